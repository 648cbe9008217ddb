// The map from a surface to its remesh: one-to-one, from boundary to boundary, the same for every number of threads;
// and the nearest points, each in its cell's triangles.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "map/nearest_points.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_map_to_remesh {

void require_point(const Mesh& mesh, const SurfacePoint& point) {
  REQUIRE(point.face.valid());
  REQUIRE(point.face.value() < mesh.face_count());
  for (const double b : point.bary) REQUIRE(b >= 0);
  REQUIRE(std::abs(point.bary[0] + point.bary[1] + point.bary[2] - 1) < 1e-15 * 4);
}

/// Whether two vertices have the same point.
bool has_repeated_point(const Mesh& remesh, const RemeshMap& map) {
  std::vector<std::array<double, 3>> positions;
  for (const SurfacePoint& p : map.points) {
    const Vec3 at = position(remesh, p);
    positions.push_back({at.x(), at.y(), at.z()});
  }
  std::sort(positions.begin(), positions.end());
  return std::adjacent_find(positions.begin(), positions.end()) != positions.end();
}

void require_map(const Mesh& surface, const RemeshResult& result) {
  const RemeshMap map = map_to_remesh(surface, result);
  CAPTURE(map.obstacle);
  CHECK(map.one_to_one);
  CHECK(!has_repeated_point(result.mesh, map));
  REQUIRE(map.points.size() == static_cast<std::size_t>(surface.vertex_count()));
  REQUIRE(map.origins.size() == static_cast<std::size_t>(result.mesh.vertex_count()));
  for (const SurfacePoint& point : map.points) require_point(result.mesh, point);
  for (const SurfacePoint& point : map.origins) require_point(surface, point);
  CHECK(map.kept_faces + map.reversed_faces + map.collapsed_faces == surface.face_count());
  CHECK(map.mean_move <= map.largest_move);
}

TEST_CASE("map to a remesh: it is one-to-one, and no two vertices have the same point") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {5, 40}) {
      for (const unsigned seed : test::thinned({1u, 2u})) {
        INFO(name << ", " << count << " generators, seed " << seed);
        require_map(mesh, remesh(mesh, test::random_generators(mesh, count, seed)));
      }
    }
  }
}

TEST_CASE("map to a remesh: where the remesh's triangles are not those of the cells, it says so") {
  const Mesh sphere = test::make_sphere(3);
  RemeshResult result = remesh(sphere, test::random_generators(sphere, 40, 1));
  std::vector<std::array<VertexId, 3>> faces;
  for (std::int32_t f = 0; f < result.mesh.face_count(); ++f) {
    faces.push_back(result.mesh.vertices(FaceId(f)));
    for (VertexId& v : faces.back()) {
      if (v.value() < 2) v = VertexId(1 - v.value());
    }
  }
  result.mesh = Mesh(result.mesh.positions(), faces);
  const RemeshMap map = map_to_remesh(sphere, result);
  CHECK(!map.one_to_one);
  CHECK_THAT(map.obstacle, Catch::Matchers::Contains("of the remesh"));
  CHECK(map.origins.raw() == result.generators);
  for (const SurfacePoint& point : map.points) require_point(result.mesh, point);
}

TEST_CASE("map to a remesh: a sphere keeps the orientation of nearly every face") {
  const Mesh sphere = test::make_sphere(4);
  const RemeshMap map = map_to_remesh(sphere, remesh(sphere, test::random_generators(sphere, 100, 1)));
  CHECK(static_cast<double>(map.kept_faces) >= 0.97 * sphere.face_count());
  CHECK(map.largest_move > 0);
  CHECK(map.largest_move < 0.5);  // vertices slide towards better triangles
  CHECK(map.mean_move < 0.06);
}

TEST_CASE("map to a remesh: a boundary goes to the boundary") {
  const Mesh half = test::make_half_sphere(3);
  const RemeshResult result = remesh(half, test::random_generators(half, 40, 2));
  const RemeshMap map = map_to_remesh(half, result);
  for (std::int32_t i = 0; i < half.vertex_count(); ++i) {
    if (half.is_boundary(VertexId(i))) CHECK(is_on_boundary(result.mesh, map.points[VertexId(i)]));
  }
  for (std::int32_t i = 0; i < result.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    CHECK(is_on_boundary(half, map.origins[v]) == result.mesh.is_boundary(v));
  }
}

TEST_CASE("map to a remesh: a generator at a vertex, and the vertex of the remesh, are each other's points") {
  const Mesh sphere = test::make_sphere(3);
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 30; ++i) generators.push_back(vertex_point(sphere, VertexId(i * 20)));
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const RemeshResult result = remesh(sphere, generators, options);
  const RemeshMap map = map_to_remesh(sphere, result);
  for (int i = 0; i < 30; ++i) {
    INFO("vertex " << i);
    CHECK(position(result.mesh, map.points[VertexId(i * 20)]) == result.mesh.position(VertexId(i)));
    CHECK(position(sphere, map.origins[VertexId(i)]) == sphere.position(VertexId(i * 20)));
  }
}

std::vector<SurfacePoint> all_vertices(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (const VertexId v : mesh.vertices()) points.push_back(vertex_point(mesh, v));
  return points;
}

/// The remesh whose vertices are all those of the surface.
RemeshResult remesh_onto_itself(const Mesh& mesh) {
  RemeshOptions options;
  options.placement.method = Placement::generator;
  return remesh(mesh, all_vertices(mesh), options);
}

TEST_CASE("map to a remesh: a vertex that is an origin within rounding goes to the remesh's vertex, bit by bit") {
  const Mesh cube = test::make_plate(1, 1);
  RemeshResult result = remesh_onto_itself(cube);
  // So near the corners that the nearest point is the corner in a face of the cube, but not yet in a face of its cell.
  std::vector<Vec3> positions = result.mesh.positions();
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : positions) centre += p / double(positions.size());
  for (Vec3& p : positions) p += 1.8 * kBarycentricSnap * (centre - p);
  std::vector<std::array<VertexId, 3>> faces;
  for (const FaceId f : result.mesh.faces()) faces.push_back(result.mesh.vertices(f));
  result.mesh = Mesh(std::move(positions), std::move(faces));
  const RemeshMap map = map_to_remesh(cube, result);
  REQUIRE(map.one_to_one);
  for (const VertexId v : cube.vertices()) {
    INFO("vertex " << v.value());
    CHECK(position(cube, map.origins[v]) == cube.position(v));
    CHECK(position(result.mesh, map.points[v]) == result.mesh.position(v));
  }
}

TEST_CASE("map to a remesh: no face of a cube is reversed, whichever side's face its corners' points name") {
  const Mesh cube = test::make_plate(1, 1);
  const RemeshResult result = remesh_onto_itself(cube);
  const RemeshMap map = map_to_remesh(cube, result);
  CHECK(map.largest_move == 0);
  CHECK(map.kept_faces == cube.face_count());
}

TEST_CASE("map to a remesh: the same with any number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(4, 3);
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, 60, 3));
  const RemeshMap one = map_to_remesh(mesh, result, 1), four = map_to_remesh(mesh, result, 4);
  CHECK(one.points == four.points);
  CHECK(one.kept_faces == four.kept_faces);
  CHECK(one.origins == four.origins);
  CHECK(one.largest_move == four.largest_move);
  CHECK(one.mean_move == four.mean_move);
}

TEST_CASE("map to a remesh: a mesh that was remeshed onto itself keeps every face") {
  const Mesh grid = test::make_grid(6, 6);
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const RemeshResult result = remesh(grid, all_vertices(grid), options);
  const RemeshMap map = map_to_remesh(grid, result);
  CHECK(map.kept_faces == grid.face_count());
  CHECK(map.largest_move < 1e-9);
}

TEST_CASE("map to a remesh: refuses the remesh of another surface") {
  const Mesh sphere = test::make_sphere(2), other = test::make_sphere(3);
  const RemeshResult result = remesh(sphere, test::random_generators(sphere, 10, 1));
  CHECK_THROWS_AS(map_to_remesh(other, result), Error);
}

/// Whether a triangle has the vertex or one of its neighbours as a corner.
bool is_near(const Mesh& mesh, FaceId f, VertexId vertex, const Cell& cell) {
  for (const VertexId v : mesh.vertices(f)) {
    const GeneratorId g(v.value());
    if (v == vertex || std::binary_search(cell.neighbours.begin(), cell.neighbours.end(), g)) return true;
  }
  return false;
}

TEST_CASE("nearest points: each is in a triangle of the vertex's cell or of a neighbour") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {5, 40}) {
      INFO(name << ", " << count << " generators");
      const RemeshResult result = remesh(mesh, test::random_generators(mesh, count, 1));
      const auto points = nearest_points(mesh, result, 0);
      REQUIRE(points.size() == static_cast<std::size_t>(mesh.vertex_count()));
      for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
        const GeneratorId label = result.diagram.vertex_label[VertexId(i)];
        REQUIRE(is_near(result.mesh, points[VertexId(i)].face, VertexId(label.value()), result.diagram.cells[label]));
        REQUIRE((!mesh.is_boundary(VertexId(i)) || is_on_boundary(result.mesh, points[VertexId(i)])));
      }
    }
  }
}

}  // namespace gvd::test_map_to_remesh
