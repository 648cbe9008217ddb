#include <numbers>

#include "repair/cell_loops.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_cell_loops {

std::vector<SurfacePoint> find_loop(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int cell = 0) {
  const Diagram diagram = compute_diagram(mesh, generators);
  return CellLoops(mesh, diagram).find(GeneratorId(cell));
}

TEST_CASE("cell loops: a disc and a closed sphere have none, however small") {
  const Mesh triangle = test::make_triangle();
  CHECK(find_loop(triangle, {vertex_point(triangle, VertexId(0))}).empty());
  const Mesh pillow = test::make_pillow();
  CHECK(find_loop(pillow, {vertex_point(pillow, VertexId(0))}).empty());
  const Mesh sphere = test::make_sphere(2);
  CHECK(find_loop(sphere, {vertex_point(sphere, VertexId(0))}).empty());
  const Mesh grid = test::make_grid(5, 5);
  for (int cell = 0; cell < 4; ++cell) CHECK(find_loop(grid, test::random_generators(grid, 4, 1), cell).empty());
}

TEST_CASE("cell loops: a cell round a cylinder is divided in thirds round it") {
  const Mesh ring = test::make_ring(24, 6);
  const SurfacePoint generator = vertex_point(ring, VertexId(3));
  const auto points = find_loop(ring, {generator});
  REQUIRE(points.size() == 2);
  // The generator lies on the loop: the three are a third of the way round apart.
  std::vector<Vec3> corners{position(ring, generator), position(ring, points[0]), position(ring, points[1])};
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 a = corners[i], b = corners[(i + 1) % 3];
    a.z() = b.z() = 0;
    CHECK(std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) ==
          Approx(2 * std::numbers::pi / 3).epsilon(0.05));
  }
}

TEST_CASE("cell loops: of two loops of a torus the shorter one is found") {
  const Mesh torus = test::make_torus(24, 12);
  const auto points = find_loop(torus, {vertex_point(torus, VertexId(0))});
  REQUIRE(points.size() >= 2);
  const Vec3 start = torus.position(VertexId(0));
  for (const SurfacePoint& p : points) CHECK((position(torus, p) - start).norm() < 3 * 0.35);
}

TEST_CASE("cell loops: far from the generator the loop gets three points of its own") {
  // A wide tube with a thin neck at its far end: the shortest way round, there and back included, is at the neck.
  const Mesh tube = [] {
    const Mesh ring = test::make_ring(12, 40);
    std::vector<Vec3> positions = ring.positions();
    for (Vec3& p : positions) {
      const double width = p.z() < 0.4 ? 4 : 0.2;
      p = Vec3(width * p.x(), width * p.y(), 10 * p.z());
    }
    std::vector<std::array<VertexId, 3>> faces;
    for (int f = 0; f < ring.face_count(); ++f) faces.push_back(ring.vertices(FaceId(f)));
    return Mesh(std::move(positions), std::move(faces));
  }();
  const auto points = find_loop(tube, {vertex_point(tube, VertexId(0))});
  REQUIRE(points.size() == 3);
  for (const SurfacePoint& p : points) CHECK(position(tube, p).z() > 3.8);  // at the neck, or where it begins
}

TEST_CASE("cell loops: exactly the cells that are no discs have one, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 6}) {
      CAPTURE(name, count);
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 3));
      CellLoops loops(mesh, diagram);
      for (const Cell& cell : diagram.cells) {
        const bool is_disc_or_sphere = cell.components == 1 && cell.euler_characteristic >= 1;
        const auto points = loops.find(cell.generator);
        CHECK(points.empty() == is_disc_or_sphere);
        for (const SurfacePoint& p : points) CHECK((p.face.valid() && p.face.value() < mesh.face_count()));
      }
    }
  }
}

}  // namespace gvd::test_cell_loops
