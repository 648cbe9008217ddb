// The map from a surface to its remesh: every vertex, in its cell's triangles, for every number of threads.
#include <algorithm>
#include <cmath>

#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

using namespace gvd;

namespace {

void require_point(const Mesh& mesh, const SurfacePoint& point) {
  REQUIRE(point.face.valid());
  REQUIRE(point.face.value() < mesh.face_count());
  for (const double b : point.bary) REQUIRE(b >= 0);
  REQUIRE(std::abs(point.bary[0] + point.bary[1] + point.bary[2] - 1) < 1e-15 * 4);
}

/// Whether a triangle has the vertex or one of its neighbours as a corner.
bool is_near(const Mesh& mesh, FaceId f, VertexId vertex, const Cell& cell) {
  for (const VertexId v : mesh.vertices(f)) {
    const GeneratorId g(v.value());
    if (v == vertex || std::binary_search(cell.neighbours.begin(), cell.neighbours.end(), g)) return true;
  }
  return false;
}

void require_map(const Mesh& surface, const RemeshResult& result) {
  const RemeshMap map = map_to_remesh(surface, result);
  REQUIRE(map.points.size() == static_cast<std::size_t>(surface.vertex_count()));
  for (std::int32_t i = 0; i < surface.vertex_count(); ++i) {
    const VertexId v(i);
    require_point(result.mesh, map.points[v]);
    const GeneratorId label = result.diagram.vertex_label[v];
    REQUIRE(is_near(result.mesh, map.points[v].face, VertexId(label.value()), result.diagram.cells[label]));
  }
  CHECK(map.kept_faces + map.reversed_faces + map.collapsed_faces == surface.face_count());
}

}  // namespace

TEST_CASE("map to a remesh: every vertex has a point in a triangle of its cell or of a neighbour") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {5, 40}) {
      INFO(name << ", " << count << " generators");
      require_map(mesh, remesh(mesh, test::random_generators(mesh, count, 1)));
    }
  }
}

TEST_CASE("map to a remesh: a sphere keeps the orientation of nearly every face") {
  const Mesh sphere = test::make_sphere(4);
  const RemeshMap map = map_to_remesh(sphere, remesh(sphere, test::random_generators(sphere, 100, 1)));
  CHECK(static_cast<double>(map.kept_faces) >= 0.97 * sphere.face_count());
  CHECK(map.largest_move > 0);
  CHECK(map.largest_move < 0.15);
}

TEST_CASE("map to a remesh: a boundary goes to the boundary") {
  const Mesh half = test::make_half_sphere(3);
  const RemeshResult result = remesh(half, test::random_generators(half, 40, 2));
  const RemeshMap map = map_to_remesh(half, result);
  for (std::int32_t i = 0; i < half.vertex_count(); ++i) {
    if (half.is_boundary(VertexId(i))) CHECK(is_on_boundary(result.mesh, map.points[VertexId(i)]));
  }
}

TEST_CASE("map to a remesh: a generator at a vertex, and the vertex of the remesh, are each other's points") {
  const Mesh sphere = test::make_sphere(3);
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 30; ++i) generators.push_back(vertex_point(sphere, VertexId(i * 20)));
  const RemeshResult result = remesh(sphere, generators);
  const RemeshMap map = map_to_remesh(sphere, result);
  for (int i = 0; i < 30; ++i) {
    INFO("vertex " << i);
    CHECK(position(result.mesh, map.points[VertexId(i * 20)]) == result.mesh.position(VertexId(i)));
  }
}

TEST_CASE("map to a remesh: the same with any number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(4, 3);
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, 60, 3));
  const RemeshMap one = map_to_remesh(mesh, result, 1), four = map_to_remesh(mesh, result, 4);
  CHECK(one.points == four.points);
  CHECK(one.kept_faces == four.kept_faces);
  CHECK(one.largest_move == four.largest_move);
}

TEST_CASE("map to a remesh: a mesh that was remeshed onto itself keeps every face") {
  const Mesh grid = test::make_grid(6, 6);
  std::vector<SurfacePoint> generators;
  for (std::int32_t v = 0; v < grid.vertex_count(); ++v) generators.push_back(vertex_point(grid, VertexId(v)));
  const RemeshResult result = remesh(grid, generators);
  const RemeshMap map = map_to_remesh(grid, result);
  CHECK(map.kept_faces == grid.face_count());
  CHECK(map.largest_move < 1e-9);
}

TEST_CASE("map to a remesh: refuses the remesh of another surface") {
  const Mesh sphere = test::make_sphere(2), other = test::make_sphere(3);
  const RemeshResult result = remesh(sphere, test::random_generators(sphere, 10, 1));
  CHECK_THROWS_AS(map_to_remesh(other, result), Error);
}
