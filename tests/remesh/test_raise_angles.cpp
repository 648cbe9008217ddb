// Thin triangles of a fit: their vertices move for better angles, and pay for the distance.
#include <algorithm>
#include <cmath>

#include "cell_quadrics.hpp"
#include "fit_vertices.hpp"
#include "gvd/quality.hpp"
#include "move_guard.hpp"
#include "raise_angles.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_raise_angles {

/// A mesh as the remesh of itself.
struct Copy {
  explicit Copy(Mesh given)
      : mesh(std::move(given)),
        generators(list_generators(mesh)),
        guard(mesh, mesh, generators, list_centroids(mesh), {}),
        systems(mesh.face_count()),
        plan{&mesh, IdVector<GeneratorId, CreaseCell>(generators.size()),
             std::vector<VertexRole>(generators.size(), VertexRole::free),
             std::vector<double>(generators.size(), 0.01)} {}

  static std::vector<SurfacePoint> list_generators(const Mesh& mesh) {
    std::vector<SurfacePoint> points;
    for (int v = 0; v < mesh.vertex_count(); ++v) points.push_back(vertex_point(mesh, VertexId(v)));
    return points;
  }
  static std::vector<SurfacePoint> list_centroids(const Mesh& mesh) {
    std::vector<SurfacePoint> points;
    for (int f = 0; f < mesh.face_count(); ++f) points.push_back(make_surface_point(FaceId(f), {0.25, 0.25, 0.5}));
    return points;
  }
  std::vector<Vec3> raise(const AnglePrice& price) const {
    return raise_angles({&mesh, &systems, &guard, &plan}, price, mesh.positions());
  }

  Mesh mesh;
  std::vector<SurfacePoint> generators;
  MoveGuard guard;
  FaceSystems systems;
  SpringPlan plan;
};

/// A sphere whose vertices were moved at random.
Mesh make_uneven_sphere(unsigned seed) {
  const Mesh sphere = test::make_sphere(3);
  test::Random random(seed);
  std::vector<Vec3> positions = sphere.positions();
  const double far = 0.4 * sphere.mean_edge_length();
  for (Vec3& p : positions) p += far * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
  for (Vec3& p : positions) p.normalize();
  return with_positions(sphere, positions);
}

double least_angle(const Mesh& mesh) { return compute_triangle_quality(mesh).angle_min; }

TEST_CASE("the smallest angles grow where distances do not matter") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Copy uneven(make_uneven_sphere(seed));
    const Mesh after = with_positions(uneven.mesh, uneven.raise({30, 1}));
    CHECK(least_angle(after) > 5 + least_angle(uneven.mesh));
    CHECK(compute_triangle_quality(after).percent_below_30 <
          0.2 * compute_triangle_quality(uneven.mesh).percent_below_30);
  }
}

TEST_CASE("vertices stay where they are held, where triangles are good, and where distances cost more") {
  Copy uneven(make_uneven_sphere(0)), steep(make_uneven_sphere(0));
  const Copy sphere(test::make_sphere(2));
  for (FaceSystem& system : steep.systems) system.matrix.setIdentity();
  CHECK(uneven.raise({30, 0}) == uneven.mesh.positions());
  CHECK(sphere.raise({30, 1}) == sphere.mesh.positions());
  double far = 0;
  const std::vector<Vec3> moved = steep.raise({30, 1});
  for (std::size_t v = 0; v < moved.size(); ++v) far = std::max(far, (moved[v] - steep.mesh.positions()[v]).norm());
  CHECK(far < 0.1 * steep.mesh.mean_edge_length());
  uneven.plan.roles.assign(uneven.plan.roles.size(), VertexRole::held);
  CHECK(uneven.raise({30, 1}) == uneven.mesh.positions());
}

TEST_CASE("triangles without thin angles get better, too, and less so at creases") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Copy uneven(make_uneven_sphere(seed));
    const auto quality = [&](double weight) {
      for (FaceSystem& system : uneven.systems) system.matrix = weight * FaceSystem::Block::Identity();
      return compute_triangle_quality(with_positions(uneven.mesh, uneven.raise({30, 0, 1}))).q_average;
    };
    const double was = compute_triangle_quality(uneven.mesh).q_average, free = quality(0), paid = quality(0.01);
    CHECK(free > was + 0.05);
    CHECK(paid > was);
    CHECK(paid < free);
    uneven.plan.roles.assign(uneven.plan.roles.size(), VertexRole::near_crease);
    const double at_crease = quality(0.01);
    CHECK(at_crease > was);
    CHECK(at_crease < paid);
  }
}

TEST_CASE("a vertex goes along a crease rather than off it") {
  // A fan around a vertex that is too near one of its neighbours; its distances hold it in y and z.
  const Mesh fan({{0.1, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {-0.5, 1, 0}, {-0.3, 0, 0}, {-0.5, -1, 0}, {0.5, -1, 0}},
                 {{VertexId(0), VertexId(1), VertexId(2)},
                  {VertexId(0), VertexId(2), VertexId(3)},
                  {VertexId(0), VertexId(3), VertexId(4)},
                  {VertexId(0), VertexId(4), VertexId(5)},
                  {VertexId(0), VertexId(5), VertexId(6)},
                  {VertexId(0), VertexId(6), VertexId(1)}});
  Copy copy(fan);
  copy.plan.areas.assign(copy.plan.areas.size(), 1);
  copy.plan.roles.assign(copy.plan.roles.size(), VertexRole::held);
  copy.plan.roles[0] = VertexRole::free;
  for (FaceSystem& system : copy.systems) system.matrix.diagonal() << 0, 1, 1, 0, 0, 0, 0, 0, 0;
  const Vec3 moved = copy.raise({40, 0.05})[0];
  CHECK(moved.x() > fan.position(VertexId(0)).x() + 0.05);
  CHECK(std::abs(moved.y()) < 0.02);
  CHECK(std::abs(moved.z()) < 1e-9);
}

}  // namespace gvd::test_raise_angles
