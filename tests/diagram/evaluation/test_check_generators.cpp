#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/evaluation/check_generators.hpp"
#include "support/catch.hpp"
#include "support/three_cells.hpp"

namespace gvd::test_check_generators {

using test::ThreeCells;

using Lines = std::vector<std::string>;

Lines find(const ThreeCells& x) { return x.run(check_generators); }

TEST_CASE("the generators of a sound diagram lie in their cells") { CHECK(find(ThreeCells()).empty()); }

TEST_CASE("one in another cell, and an area that is not a number") {
  ThreeCells broken;
  std::swap(broken.diagram.generators[0], broken.diagram.generators[2]);
  CHECK(find(broken) == Lines{"(1) generator 0: lies outside its cell", "(1) generator 2: lies outside its cell"});
  ThreeCells area;
  area.cell(1).area = std::nan("");
  CHECK(find(area) == Lines{"(1) cell 1: its area is negative or not a number"});
}

}  // namespace gvd::test_check_generators
