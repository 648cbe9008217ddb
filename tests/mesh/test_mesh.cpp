#include <cmath>

#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_mesh {

std::vector<std::array<VertexId, 3>> triangles(std::initializer_list<std::array<int, 3>> list) {
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto& [a, b, c] : list) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return faces;
}

const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}};

void require_refused(const std::vector<std::array<VertexId, 3>>& faces, std::size_t vertices, const std::string& part) {
  const std::vector<Vec3> positions(kSquare.begin(), kSquare.begin() + static_cast<std::ptrdiff_t>(vertices));
  try {
    Mesh mesh(positions, faces);
    FAIL("accepted, expected: " << part);
  } catch (const Error& error) {
    REQUIRE(error.code() == ErrorCode::precondition);
    REQUIRE_THAT(error.what(), Catch::Matchers::Contains(part));
  }
}

TEST_CASE("a mesh that breaks a property can't be built") {
  require_refused(triangles({{0, 1, 9}}), 4, "refers to vertex 9");
  require_refused(triangles({{0, 1, 1}}), 2, "same vertex twice");
  require_refused(triangles({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), 5, "edge 0-1 has 3 faces");
  require_refused(triangles({{0, 1, 2}, {0, 1, 3}}), 4, "same direction");
  require_refused(triangles({{0, 1, 2}}), 4, "belongs to no face");
  require_refused(triangles({{0, 1, 2}, {0, 3, 4}}), 5, "several fans");
}

TEST_CASE("zero-length edges and coordinates that are not finite are refused") {
  CHECK_THROWS_AS(Mesh({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, triangles({{0, 1, 2}})), Error);
  CHECK_THROWS_AS(Mesh({{0, 0, 0}, {0, NAN, 0}, {1, 0, 0}}, triangles({{0, 1, 2}})), Error);
}

TEST_CASE("the largest coordinate is one by absolute value, in any direction") {
  CHECK(Mesh().largest_coordinate() == 0);
  CHECK(Mesh({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, triangles({{0, 1, 2}})).largest_coordinate() == 2);
  CHECK(Mesh({{-1, 0, -5}, {1, 0, -3}, {0, 2, -4}}, triangles({{0, 1, 2}})).largest_coordinate() == 5);
  CHECK(Mesh({{-3, -1, -1}, {-4, -1, -1}, {-3, -2, -1}}, triangles({{0, 1, 2}})).largest_coordinate() == 4);
}

TEST_CASE("a vertex may have thousands of faces") {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<VertexId, 3>> faces;
  constexpr int kFaces = 3000;
  for (int i = 0; i < kFaces; ++i) {
    const double angle = 6.283185307179586 * i / kFaces;
    positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.push_back({VertexId(0), VertexId(1 + i), VertexId(1 + (i + 1) % kFaces)});
  }
  const Mesh mesh(positions, faces);
  CHECK(mesh.edge_count() == 2 * kFaces);
  CHECK(compute_mesh_summary(mesh).boundary_loops == 1);
  CHECK_FALSE(mesh.is_boundary(VertexId(0)));
}

TEST_CASE("connectivity is consistent on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (int i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfedgeId h(i), twin = mesh.twin(h);
      REQUIRE(mesh.to(h) == mesh.from(Mesh::next(h)));
      if (!twin.valid()) continue;
      REQUIRE(mesh.twin(twin) == h);
      REQUIRE(mesh.edge(twin) == mesh.edge(h));
      REQUIRE(mesh.from(twin) == mesh.to(h));
    }
    for (int i = 0; i < mesh.vertex_count(); ++i) REQUIRE(mesh.from(mesh.halfedge(VertexId(i))) == VertexId(i));
  }
}

TEST_CASE("the summary counts what the families were made with") {
  const auto summary = [](const Mesh& mesh) { return compute_mesh_summary(mesh); };
  CHECK(summary(test::make_sphere(2)).euler_characteristic == 2);
  CHECK(summary(test::make_torus(12, 8)).euler_characteristic == 0);
  CHECK(summary(test::make_genus3(2)).euler_characteristic == -4);
  CHECK(summary(test::make_grid(3, 2)).boundary_loops == 1);
  CHECK(summary(test::make_grid(3, 2)).area == Approx(6));
  CHECK(summary(test::make_ring(12, 3)).boundary_loops == 2);
  CHECK(summary(test::make_half_sphere(2)).boundary_loops == 1);
  CHECK(summary(test::make_two_components()).components == 2);
}

TEST_CASE("the area of a mesh is that of its summary, and 0 without faces") {
  CHECK(compute_area(Mesh()) == 0);
  CHECK(compute_area(test::make_grid(3, 3)) == Approx(compute_mesh_summary(test::make_grid(3, 3)).area));
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    double area = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.vertices(FaceId(f));
      area += (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).norm() / 2;
    }
    CHECK(compute_area(mesh) == Approx(area));
  }
}

}  // namespace gvd::test_mesh
