// Cells whose vertices have to go to creases or to the boundary.
#include <algorithm>
#include <cmath>

#include "gvd/remesh.hpp"
#include "placement/crease_cells.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_crease_cells {

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

}  // namespace gvd::test_crease_cells
