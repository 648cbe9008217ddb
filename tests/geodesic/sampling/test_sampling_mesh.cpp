#include <cmath>
#include <numbers>

#include "geodesic/sampling/sampling_mesh.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_sampling_mesh {

constexpr std::int64_t kMany = 1 << 20;

double smallest_angle(const Mesh& mesh) {
  double smallest = 4;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto& v = mesh.vertices(FaceId(f));
      const auto at = [&](int k) { return mesh.position(v[(i + k) % 3]); };
      const Vec3 p = at(1) - at(0), q = at(2) - at(0);
      smallest = std::min(smallest, std::atan2(p.cross(q).norm(), p.dot(q)));
    }
  }
  return smallest;
}

TEST_CASE("sampling mesh: without edges to split it is the input itself") {
  const Mesh mesh = test::make_triangle();
  const SamplingMesh same(mesh, {kInfinity, 0, kMany}, {});
  CHECK(&same.mesh() == &mesh);
  const SurfacePoint p = make_surface_point(FaceId(0), {0.2, 0.3, 0.5});
  CHECK(same.to_input(p) == p);
  CHECK(same.to_input(VertexId(2)) == vertex_point(mesh, VertexId(2)));
}

TEST_CASE("sampling mesh: the longest edge is split first, until there are enough vertices") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const SamplingMesh split(mesh, {kInfinity, 4, 0}, {});
  REQUIRE(split.mesh().vertex_count() == 4);
  CHECK((split.mesh().position(VertexId(3)) - Vec3(2, 1.5, 0)).norm() < 1e-15);
  CHECK(split.to_input(VertexId(3)).kind() == SurfacePoint::Kind::edge);
  CHECK(longest_edge(split.mesh()) == 4);
}

TEST_CASE("sampling mesh: the number of vertices added for length is bounded") {
  const Mesh mesh = test::make_pillow();
  const SamplingMesh split(mesh, {1e-3, 0, 10}, {});
  CHECK(split.mesh().vertex_count() == mesh.vertex_count() + 10);
}

TEST_CASE("sampling mesh: a face without area is split like any other") {
  const Mesh line = test::make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const SamplingMesh split(line, {0.5, 0, kMany}, {});
  CHECK(longest_edge(split.mesh()) <= 0.5);
}

TEST_CASE("sampling mesh: cancelling throws") {
  const Mesh mesh = test::make_sphere(0);
  const auto split_all = [&] { SamplingMesh(mesh, {1e-3, 0, kMany}, [](std::string_view, double) { return false; }); };
  CHECK_THROWS_AS(split_all(), Error);
}

TEST_CASE("sampling mesh: on every family edges are short, angles bounded, and points lie where they were") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const double longest = 0.4 * longest_edge(mesh);
    const SamplingMesh split(mesh, {longest, 0, kMany}, {});
    const Mesh& fine = split.mesh();
    CHECK(longest_edge(fine) <= longest);
    CHECK(compute_mesh_summary(fine).euler_characteristic == compute_mesh_summary(mesh).euler_characteristic);
    CHECK(compute_mesh_summary(fine).area == Approx(compute_mesh_summary(mesh).area));
    CHECK(smallest_angle(fine) >= 0.5 * smallest_angle(mesh) - 1e-9);
    for (int v = 0; v < fine.vertex_count(); ++v) {
      const Vec3 at = position(mesh, split.to_input(VertexId(v)));
      CHECK((at - fine.position(VertexId(v))).norm() < 1e-12 * mesh.bbox_diagonal());
    }
    for (const SurfacePoint& p : test::random_generators(fine, 30, 2)) {
      CHECK((position(mesh, split.to_input(p)) - position(fine, p)).norm() < 1e-12 * mesh.bbox_diagonal());
    }
  }
}

TEST_CASE("sampling spacing: equilateral triangles of this side have two faces for each point") {
  const double side = even_spacing(100, 50);
  CHECK(2 * 50 * std::sqrt(3.0) / 4 * side * side == Approx(100));
  CHECK(even_spacing(0, 3) == 0);
}

TEST_CASE("sampling spacing: the number of splits grows with mesh and generators, up to a bound") {
  const Mesh mesh = test::make_tetrahedron();
  CHECK(max_splits(mesh, 1) == 20);
  CHECK(max_splits(mesh, 10) == 56);
  CHECK(max_splits(mesh, std::int64_t{1} << 40) == kMaxSamplingVertices);
}

}  // namespace gvd::test_sampling_mesh
