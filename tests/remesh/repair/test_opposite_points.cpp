// Points opposite the generator of a cell that goes round a limb, and the borders of cells.
#include <algorithm>
#include <cmath>

#include "repair/cell_topology.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_opposite_points {

std::vector<SurfacePoint> find(const Mesh& mesh, const std::vector<SurfacePoint>& generators, GeneratorId cell) {
  const Diagram diagram = compute_diagram(mesh, generators);
  return find_opposite_points(mesh, diagram, cell, CellLoops(mesh, diagram, cut_faces(mesh, diagram)).borders(cell));
}

std::vector<SurfacePoint> with(std::vector<SurfacePoint> points, const SurfacePoint& more) {
  points.push_back(more);
  return points;
}

/// A tube along z, open at both ends, whose girth is near 2 pi. Faces are as high as it is.
Mesh make_tube(double height) { return test::stretched(test::make_ring(12, 1), {1, 1, 2 * height}); }

TEST_CASE("opposite points: on a tube, however long, as far along it as the generator") {
  for (const double height : {1.0, 10.0, 1000.0, 1e6}) {
    const Mesh tube = make_tube(height);
    for (unsigned seed = 0; seed < 10; ++seed) {
      CAPTURE(height, seed);
      const auto given = test::random_generators(tube, 1, seed);
      const auto points = find(tube, given, GeneratorId(0));
      REQUIRE(points.size() == 1);
      const Diagram after = compute_diagram(tube, with(given, points[0]));
      for (const Cell& cell : after.cells) {
        CHECK(cell.components == 1);
        CHECK(cell.euler_characteristic == 1);
      }
    }
  }
}

TEST_CASE("opposite points: an annulus becomes a disc nearly wherever its generator is") {
  int annuli = 0, mended = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 3}) {
      const auto given = test::random_generators(mesh, count, 7);
      const Diagram before = compute_diagram(mesh, given);
      for (const Cell& cell : before.cells) {
        if (cell.components != 1 || cell.euler_characteristic != 0 || cell.boundary_loops != 2) continue;
        CAPTURE(name, count, cell.generator.value());
        ++annuli;
        const auto points = find(mesh, given, cell.generator);
        REQUIRE(points.size() == 1);
        const Diagram after = compute_diagram(mesh, with(given, points[0]));
        const Cell& own = after.cells[cell.generator];
        mended += own.components == 1 && own.euler_characteristic == 1;
      }
    }
  }
  CHECK(annuli > 3);
  CHECK(mended >= annuli - 1);  // a path may leave a cell by faces that others share
}

TEST_CASE("opposite points: a cell with one border or none has none") {
  const Mesh sphere = test::make_sphere(1);
  CHECK(find(sphere, test::random_generators(sphere, 1, 1), GeneratorId(0)).empty());
  CHECK(find(sphere, test::random_generators(sphere, 2, 1), GeneratorId(0)).empty());
  const Mesh grid = test::make_grid(3, 3);
  CHECK(find(grid, test::random_generators(grid, 1, 1), GeneratorId(0)).empty());
}

TEST_CASE("borders of a cell: closed, as many as the diagram counts, and their lengths are those of its bisectors") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 5, 2));
    const CellLoops loops(mesh, diagram, cut_faces(mesh, diagram));
    for (const Cell& cell : diagram.cells) {
      CHECK(std::ssize(loops.borders(cell.generator)) == cell.boundary_loops);
      for (const auto& border : loops.borders(cell.generator)) CHECK(border.size() >= 3);
    }
  }
}

}  // namespace gvd::test_opposite_points
