// Decimated copies: their topology, and the ways between a mesh and its copy.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "copy_points.hpp"
#include "gvd/error.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_coarse_copy {

/// Fine members of the families, of a few thousand faces.
std::vector<test::NamedMesh> fine_family() {
  return {{"sphere", test::make_sphere(4)},
          {"torus", test::make_torus(80, 40)},
          {"plate", test::make_plate(24)},
          {"grid", test::make_grid(40, 30)},
          {"ring", test::make_ring(80, 12)},
          {"half sphere", test::make_half_sphere(4)},
          {"bumpy sphere", test::make_bumpy_sphere(4, 7)},
          {"thin-faced sphere", test::make_thin_faced_sphere(4, 3)},
          {"genus 3", test::make_genus3(12)},
          {"two components", test::make_two_components()},
          {"nested spheres", test::make_nested_spheres(0.98)}};
}

void require_same_topology(const Mesh& mesh, const Mesh& copy) {
  const MeshSummary a = compute_mesh_summary(mesh), b = compute_mesh_summary(copy);
  CHECK(b.components == a.components);
  CHECK(b.boundary_loops == a.boundary_loops);
  CHECK(b.euler_characteristic == a.euler_characteristic);
}

/// A cone of `n` faces round vertex 0: closed, or a fan whose tip is on the boundary.
Mesh make_cone(int n, bool is_closed) {
  const double turn = (is_closed ? 2 : 1) * std::numbers::pi / n;
  std::vector<Vec3> positions{Vec3::Zero()};
  for (int i = 0; i < n + (is_closed ? 0 : 1); ++i) {
    positions.emplace_back(std::cos(turn * i), std::sin(turn * i), 0.1 * std::sin(7 * turn * i));
  }
  const std::size_t rim = positions.size() - 1;
  std::vector<std::array<VertexId, 3>> faces;
  for (std::size_t i = 0; i < std::size_t(n); ++i)
    faces.push_back({VertexId(0), VertexId(1 + i), VertexId(1 + (i + 1) % rim)});
  return {std::move(positions), std::move(faces)};
}

/// Every vertex of the copy is one of the input, and every vertex of the input leads to its component of the copy.
void require_linked(const Mesh& mesh, const CoarseCopy& copy) {
  const auto component_of = [](const Mesh& m) {
    const auto of_face = compute_face_components(m);
    IdVector<VertexId, std::int32_t> component(m.vertex_count(), 0);
    for (const FaceId f : m.faces()) {
      for (const VertexId v : m.vertices(f)) component[v] = of_face[f];
    }
    return component;
  };
  const auto of_mesh = component_of(mesh), of_copy = component_of(copy.mesh);
  IdVector<VertexId, std::int32_t> partner(mesh.vertex_count(), -1);  // of a component of the copy
  REQUIRE(copy.input_vertex.count() == copy.mesh.vertex_count());
  CHECK(std::is_sorted(copy.input_vertex.begin(), copy.input_vertex.end()));
  for (const VertexId v : copy.mesh.vertices()) {
    const VertexId w = copy.input_vertex[v];
    CHECK(copy.mesh.position(v) == mesh.position(w));
    CHECK(copy.copy_vertex[w] == v);
    if (copy.mesh.is_boundary(v)) CHECK(mesh.is_boundary(w));
    std::int32_t& there = partner[VertexId(of_copy[v])];
    if (there < 0) there = of_mesh[w];
    CHECK(there == of_mesh[w]);
  }
  REQUIRE(copy.copy_vertex.count() == mesh.vertex_count());
  for (const VertexId v : mesh.vertices()) CHECK(partner[VertexId(of_copy[copy.copy_vertex[v]])] == of_mesh[v]);
}

// A walk round the tip at each collapse, or for each neighbour of the tip, would take minutes here.
TEST_CASE("cones whose tip has all faces keep their topology, and take no square of their number") {
  for (const bool is_closed : {true, false}) {
    INFO(is_closed);
    const Mesh cone = make_cone(200000, is_closed);
    const CoarseCopy copy = make_coarse_copy(cone, 20000, 1);
    CHECK(copy.mesh.face_count() == 20000);
    require_same_topology(cone, copy.mesh);
    require_linked(cone, copy);
  }
}

TEST_CASE("make_coarse_copy: topology and links hold down to the last face that can go") {
  for (const auto& [name, mesh] : fine_family()) {
    for (const int faces : {1, 60, 400}) {
      CAPTURE(name, faces);
      const CoarseCopy copy = make_coarse_copy(mesh, faces);
      require_same_topology(mesh, copy.mesh);
      require_linked(mesh, copy);
      CHECK(copy.mesh.face_count() <= std::max(faces, mesh.face_count() / 2));
    }
    CHECK(make_coarse_copy(mesh, mesh.face_count()).mesh.positions() == mesh.positions());
  }
}

TEST_CASE("make_coarse_copy: a copy has the faces that are asked for, and nearly the area") {
  for (const auto& [name, mesh] : fine_family()) {
    if (mesh.face_count() < 1200) continue;
    CAPTURE(name);
    const CoarseCopy copy = make_coarse_copy(mesh, 600);
    CHECK(copy.mesh.face_count() <= 600);
    CHECK(copy.mesh.face_count() > 590);
    CHECK(compute_area(copy.mesh) == Approx(compute_area(mesh)).epsilon(0.03));
  }
}

TEST_CASE("make_coarse_copy: boundaries stay where they are") {
  const CoarseCopy copy = make_coarse_copy(test::make_grid(60, 40), 100);
  CHECK(compute_area(copy.mesh) == Approx(60 * 40).epsilon(1e-12));
  CHECK(longest_edge(copy.mesh) < 20);
}

TEST_CASE("make_coarse_copy: parts give the same copy on any number of threads, with the topology of the whole") {
  const int finer = test::kSanitized ? 1 : 2;
  for (const Mesh& mesh : {test::make_torus(400 * finer, 350), test::make_ring(500 * finer, 300)}) {
    const CoarseCopy copy = make_coarse_copy(mesh, 3000, 1);
    CHECK(copy.mesh.face_count() <= 3000);
    require_same_topology(mesh, copy.mesh);
    require_linked(mesh, copy);
    CHECK(longest_edge(copy.mesh) < 8 * copy.mesh.mean_edge_length());
    const CoarseCopy again = make_coarse_copy(mesh, 3000, 2);
    CHECK(again.mesh.positions() == copy.mesh.positions());
    CHECK(again.mesh.face_vertices() == copy.mesh.face_vertices());
    CHECK(again.copy_vertex == copy.copy_vertex);
  }
}

TEST_CASE("make_coarse_copy: an interrupt and a number without sense are refused") {
  const Mesh mesh = test::make_sphere(3);
  CHECK_THROWS_AS(make_coarse_copy(mesh, 0), Error);
  const auto calls =
      test::require_cancelled_everywhere([&](const Progress& progress) { make_coarse_copy(mesh, 100, 1, progress); });
  CHECK(calls.contains("coarse copy"));
}

TEST_CASE("to_input and to_copy: points stay near by, and on their sheet") {
  const Mesh mesh = test::make_nested_spheres(0.98);
  const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 4);
  const auto of_mesh = compute_face_components(mesh), of_copy = compute_face_components(copy.mesh);
  const double near = longest_edge(copy.mesh) / 2;
  for (const FaceId f : copy.mesh.faces()) {
    const SurfacePoint p = make_surface_point(f, {0.2, 0.3, 0.5}), q = to_input(mesh, copy, p);
    CHECK((of_copy[f] == of_copy[FaceId(0)]) == (of_mesh[q.face] == of_mesh[FaceId(0)]));
    CHECK((position(mesh, q) - position(copy.mesh, p)).norm() < near);
    const SurfacePoint back = to_copy(mesh, copy, q);
    CHECK(of_copy[back.face] == of_copy[f]);
    CHECK((position(copy.mesh, back) - position(mesh, q)).norm() < near);
  }
  for (const VertexId v : copy.mesh.vertices()) {
    const SurfacePoint there = to_input(mesh, copy, vertex_point(copy.mesh, v));
    CHECK(vertex(mesh, there) == copy.input_vertex[v]);
    CHECK(vertex(copy.mesh, to_copy(mesh, copy, there)) == v);
  }
}

TEST_CASE("to_copy: densities keep their mean and their range") {
  const Mesh mesh = test::make_bumpy_sphere(4, 1);
  const CoarseCopy copy = make_coarse_copy(mesh, 500);
  CHECK(to_copy(mesh, copy, Density()).is_uniform());
  std::vector<double> heights;
  for (const Vec3& p : mesh.positions()) heights.push_back(3 + p.z());
  const Density density = make_vertex_density(mesh, heights), coarse = to_copy(mesh, copy, density);
  REQUIRE(coarse.corners.count() == copy.mesh.face_count());
  for (const FaceId f : copy.mesh.faces()) {
    for (std::size_t i = 0; i < 3; ++i) {
      // The part of a vertex lies within a few edges of it.
      const double height = copy.mesh.position(copy.mesh.vertices(f)[i]).z();
      CHECK(std::abs(coarse.corners[f][i] - (3 + height)) < 2 * copy.mesh.mean_edge_length());
    }
  }
  const Density even = to_copy(mesh, copy, make_face_density(mesh, std::vector<double>(mesh.face_count(), 7)));
  for (const auto& corners : even.corners) {
    for (const double value : corners) CHECK(value == Approx(7));
  }
}

TEST_CASE("sample_on_copy: as many points as asked for, apart from each other, in every component") {
  const Mesh mesh = test::make_nested_spheres(0.9);
  const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 4);
  SamplingOptions options;
  options.count = 40;
  const std::vector<SurfacePoint> points = value_or_throw(sample_on_copy(mesh, copy, options));
  CHECK(points.size() == 40);
  CHECK(are_apart(mesh, points));
  const auto component = compute_face_components(mesh);
  for (const int c : {0, 1}) {
    CHECK(std::ranges::any_of(points, [&](const SurfacePoint& p) { return component[p.face] == c; }));
  }
  CHECK_FALSE(are_apart(mesh, {points[0], points[1], points[0]}));
}

TEST_CASE("coarse copy: the decimation of one part and the moves of points tell their progress and can be cancelled") {
  const Mesh mesh = test::make_sphere(5);
  const CoarseCopy copy = make_coarse_copy(mesh, 2000);
  const auto of_copy =
      test::require_cancelled_everywhere([&](const Progress& progress) { make_coarse_copy(mesh, 2000, 1, progress); });
  CHECK(of_copy.at("coarse copy") > 8);
  SamplingOptions options;
  options.count = 300;
  const auto calls = [&](const SamplingOptions& sampling) {
    return test::require_cancelled_everywhere([&](const Progress& progress) {
      SamplingOptions reported = sampling;
      reported.progress = progress;
      sample_on_copy(mesh, copy, reported);
    });
  };
  const auto of_samples = calls(options);
  const auto of_sampling_alone = test::require_cancelled_everywhere([&](const Progress& progress) {
    SamplingOptions reported = options;
    reported.progress = progress;
    sample_generators(copy.mesh, reported);
  });
  CHECK(of_samples.at("sampling") >= of_sampling_alone.at("sampling") + 4);
}

TEST_CASE("default_copy_faces: more for larger meshes and for more generators, and at most half") {
  CHECK(default_copy_faces(9'000, 100) == 0);
  CHECK(default_copy_faces(70'000, 50) < default_copy_faces(2'000'000, 50));
  const std::int64_t few = default_copy_faces(2'000'000, 50), many = default_copy_faces(2'000'000, 5'000);
  CHECK(few > 0);
  CHECK(many > few);
  CHECK(default_copy_faces(2'000'000, 1'000'000) == 0);
}

}  // namespace gvd::test_coarse_copy
