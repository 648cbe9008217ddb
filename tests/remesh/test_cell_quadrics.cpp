// What the faces and the creases of a cell want from its vertex.
#include <algorithm>
#include <cmath>

#include "cell_quadrics.hpp"
#include "gvd/remesh.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_cell_quadrics {

TEST_CASE("three planes have their common point as optimum, one plane the foot on it") {
  Quadric corner;
  CHECK(corner.minimize(0.01) == Vec3(0, 0, 0));
  corner.add_plane({1, 0, 0}, {2, 7, 7}, 0.5);
  CHECK((corner.minimize(0.01) - Vec3(2, 0, 0)).norm() < 1e-14);
  corner.add_plane({0, 1, 0}, {7, 3, 7}, 1);
  corner.add_plane({0, 0, -1}, {7, 7, -1}, 2);
  CHECK((corner.minimize(0.01) - Vec3(2, 3, -1)).norm() < 1e-14);
}

TEST_CASE("directions along which the sum hardly changes are left out") {
  Quadric flat;
  flat.add_plane({0, 0, 1}, {0, 0, 1}, 1);
  flat.add_plane(Vec3(1e-3, 0, 1).normalized(), {0, 0, 2}, 1);
  CHECK(std::abs(flat.minimize(0.01).x()) < 0.01);
  CHECK(std::abs(flat.minimize(0).x()) > 100);
}

TEST_CASE("a line has its nearest point as optimum") {
  Quadric line;
  line.add_line({1, 0, 0}, {5, 2, 1}, 3);
  CHECK((line.minimize(0.01) - Vec3(0, 2, 1)).norm() < 1e-14);
}

TEST_CASE("the quadrics of the cells hold the whole area, and that of a flat mesh is zero in it") {
  const Mesh mesh = test::make_grid(10, 10);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 1));
  const auto quadrics = compute_cell_quadrics(mesh, diagram);
  double area = 0;
  for (const Quadric& q : quadrics) {
    area += q.area;
    CHECK(std::abs(q.minimize(0.01).z()) < 1e-12);
  }
  CHECK(area == Approx(100));
}

TEST_CASE("the optimum of a boundary cell is on the boundary, and that of a corner at the corner") {
  const Mesh mesh = test::make_grid(10, 10);
  std::vector<SurfacePoint> generators;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3 p = mesh.position(VertexId(v)) - Vec3(1, 1, 0);
    if (std::fmod(p.x(), 4) == 0 && std::fmod(p.y(), 4) == 0) generators.push_back(vertex_point(mesh, VertexId(v)));
  }
  REQUIRE(generators.size() == 9);
  const auto quadrics = compute_cell_quadrics(mesh, compute_diagram(mesh, generators));
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Vec3 from = position(mesh, generators[i]);
    const Vec3 at = from + quadrics[GeneratorId(i)].minimize(0.01);
    for (const int axis : {0, 1}) {
      const double wanted = from[axis] < 2 ? 0 : from[axis] > 8 ? 10 : from[axis];
      CHECK(at[axis] == Approx(wanted).margin(1e-9));
    }
  }
}

IdVector<GeneratorId, CreaseCell> find(const Mesh& mesh, int count) {
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, count, 1), options);
  return find_crease_cells(mesh, result.diagram, result.mesh);
}

std::int64_t count_cells(const Mesh& mesh) {
  const auto cells = find(mesh, 80);
  return std::count_if(cells.begin(), cells.end(), [](const CreaseCell& cell) { return cell.is_creased; });
}

TEST_CASE("smooth surfaces have no creased cells, and neither has noise with sharp edges") {
  CHECK(count_cells(test::make_sphere(3)) == 0);
  CHECK(count_cells(test::make_torus(24, 12)) == 0);
  CHECK(count_cells(test::make_sphere(1)) == 0);
}

TEST_CASE("cells at the rims of a plate and inside the boundary of a grid are creased") {
  CHECK(count_cells(test::make_plate(8, 0.3)) > 20);
  const auto on_grid = count_cells(test::make_grid(12, 12));
  CHECK((on_grid > 10 && on_grid < 50));
}

TEST_CASE("the direction of a crease is that of its edges") {
  int found = 0;
  for (const CreaseCell& cell : find(test::make_plate(12, 0.2), 120)) {
    if (cell.direction == Vec3(0, 0, 0)) continue;
    CHECK(cell.is_creased);
    CHECK(std::abs(cell.direction.norm() - 1) < 1e-12);
    found += cell.direction.cwiseAbs().maxCoeff() > 0.99;
  }
  CHECK(found > 20);
}

}  // namespace gvd::test_cell_quadrics
