#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/evaluation/check_topology.hpp"
#include "support/catch.hpp"
#include "support/three_cells.hpp"

namespace gvd::test_check_topology {

using test::ThreeCells;

using Lines = std::vector<std::string>;

Lines find(const ThreeCells& x) { return x.run(check_topology, ReachedFaces(x.mesh, x.diagram.generators)); }

bool one_begins(const Lines& lines, const std::string& start) {
  return lines.size() == 1 && lines[0].starts_with(start);
}

TEST_CASE("the topology of a sound diagram has no violation") { CHECK(find(ThreeCells()).empty()); }

TEST_CASE("components, genus, Euler's formula and neighbours") {
  ThreeCells components;
  components.cell(2).components = 3;  // with which the characteristic would still be possible
  CHECK(find(components) == Lines{"(6) cell 2: is not connected"});
  ThreeCells genus;
  genus.cell(2).euler_characteristic -= 2;
  CHECK(one_begins(find(genus), "(7) Euler's formula: cells 1 - bisectors 3 + branch points 1 is not "));
  ThreeCells neighbours;
  neighbours.cell(0).neighbours.pop_back();
  CHECK(find(neighbours) == Lines{"(8) the cells' neighbours are not the cells with a bisector in common"});
}

}  // namespace gvd::test_check_topology
