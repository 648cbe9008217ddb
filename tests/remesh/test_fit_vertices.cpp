// A round of the fit, on surfaces whose fit is known.
#include <cmath>

#include "fit_vertices.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_fit_vertices {

std::vector<Vec3> fit(const Mesh& remesh, const Mesh& surface, double spring) {
  const ClosestPointTree tree(surface);
  const FitTarget target{&surface, &tree, sample_surface(surface, 4000), 4000, 1};
  std::vector<VertexAnchor> anchors;
  for (const Vec3& p : remesh.positions()) anchors.push_back({p, spring * Eigen::Matrix3d::Identity()});
  return fit_vertices(remesh, find_face_systems(remesh, target), anchors);
}

TEST_CASE("a mesh on the surface stays there, one beside it is moved to it") {
  const Mesh surface = test::make_jittered_grid(6, 6, 0, 1);
  std::vector<Vec3> raised = surface.positions();
  for (Vec3& p : raised) p.z() += 0.01;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < surface.face_count(); ++f) faces.push_back(surface.vertices(FaceId(f)));
  const std::vector<Vec3> same = fit(surface, surface, 1e-6), fitted = fit(Mesh(raised, faces), surface, 1e-6);
  for (std::size_t i = 0; i < same.size(); ++i) {
    CHECK((same[i] - surface.positions()[i]).norm() < 1e-9);
    CHECK(std::abs(fitted[i].z()) < 1e-3);
  }
}

TEST_CASE("strong springs hold the vertices") {
  const Mesh sphere = test::make_sphere(3), ball = test::make_sphere(1);
  const std::vector<Vec3> held = fit(ball, sphere, 1e9), free = fit(ball, sphere, 1e-3);
  for (std::size_t i = 0; i < held.size(); ++i) {
    CHECK((held[i] - ball.positions()[i]).norm() < 1e-8);
    CHECK(free[i].norm() > 1.01);  // the triangles lie inside of the sphere, so the vertices go out
  }
}

TEST_CASE("a fit is heard between the steps of its factorisation, and can be cancelled at each of them") {
  const Mesh sphere = test::make_sphere(2), ball = test::make_sphere(1);
  const ClosestPointTree tree(sphere);
  const std::vector<VertexAnchor> anchors(ball.positions().size(), {Vec3(0, 0, 0), Eigen::Matrix3d::Identity()});
  const auto run = [&](const Progress& progress) {
    const FitTarget target{&sphere, &tree, sample_surface(sphere, 4000), 4000, 1, progress};
    fit_vertices(ball, find_face_systems(ball, target), anchors, progress);
  };
  test::require_cancelled_everywhere(run);
  int last = 0;
  run([&](std::string_view, double fraction) {
    last = fraction < 1 ? 0 : last + 1;
    return true;
  });
  CHECK(last >= 5);  // two of the last samples, three round the steps of the factorisation
}

TEST_CASE("samples cover the surface evenly") {
  const Mesh torus = test::make_torus(12, 8);
  for (const double count : {10.0, 1000.0, 20000.0}) {
    double area = 0, wanted = 0;
    const auto samples = sample_surface(torus, count);
    for (const AreaSample& s : samples) area += s.area;
    for (int f = 0; f < torus.face_count(); ++f) wanted += torus.area(FaceId(f));
    CHECK(area == Approx(wanted));
    CHECK(static_cast<double>(samples.size()) > 0.5 * count);
  }
}

TEST_CASE("thin_out keeps the area and its distribution with about as many samples as asked for, and few as they are") {
  const Mesh torus = test::make_torus(60, 40);
  const auto samples = sample_surface(torus, 100);
  REQUIRE(samples.size() == 4800);
  const auto sum = [](const std::vector<AreaSample>& some, double side) {
    double area = 0;
    for (const AreaSample& s : some) area += side * s.position.x() > 0 ? s.area : 0;
    return area;
  };
  for (const double most : {100.0, 777.0, 4799.0}) {
    const auto left = thin_out(samples, most);
    CAPTURE(most, left.size());
    CHECK(double(left.size()) <= most);
    CHECK(double(left.size()) > 0.5 * most);
    for (const double side : {-1.0, 1.0}) CHECK(sum(left, side) == Approx(sum(samples, side)).epsilon(0.1));
    CHECK(sum(left, 1) + sum(left, -1) == Approx(sum(samples, 1) + sum(samples, -1)));
  }
  CHECK(thin_out(samples, 4800).size() == 4800);
  CHECK(thin_out({}, 0).empty());
}

}  // namespace gvd::test_fit_vertices
