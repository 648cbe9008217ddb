#include <cmath>

#include "io/view/cell_energy.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_cell_energy {

using namespace test;

TEST_CASE("the energy of a flat cell is the integral of the squared distance") {
  const Mesh grid = make_grid(4, 4);
  const Diagram one = compute_diagram(grid, {vertex_point(grid, VertexId(12))});
  REQUIRE(grid.position(VertexId(12)) == Vec3(2, 2, 0));
  const auto energies = io::compute_cell_energies(grid, one);
  REQUIRE(energies.size() == 1);
  CHECK(energies[GeneratorId(0)] == Approx(2.0 * 4 * 2 * 8 / 3));  // of x^2 + y^2 over [-2, 2]^2
}

TEST_CASE("the energies of two cells that share a flat square are equal and add up") {
  const Mesh grid = make_grid(8, 8);
  const Diagram two =
      compute_diagram(grid, {vertex_point(grid, VertexId(4 * 9 + 2)), vertex_point(grid, VertexId(4 * 9 + 6))});
  const auto energies = io::compute_cell_energies(grid, two);
  const double exact = 8 * 16.0 / 3 + 4 * 128.0 / 3;  // x in [-2, 2] and y in [-4, 4]
  for (const double energy : energies) CHECK(energy == Approx(exact).epsilon(1e-12));
}

TEST_CASE("faces that no generator reaches have no energy") {
  const Mesh both = make_two_components();
  const Diagram diagram = compute_diagram(both, {vertex_point(both, VertexId(0))});
  const auto energies = io::compute_cell_energies(both, diagram);
  CHECK(std::isfinite(energies[GeneratorId(0)]));
  CHECK(energies[GeneratorId(0)] > 0);
  CHECK(io::compute_cell_energies(both, Diagram()).empty());
}

}  // namespace gvd::test_cell_energy
