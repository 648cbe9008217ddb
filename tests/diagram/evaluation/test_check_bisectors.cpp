#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/evaluation/check_bisectors.hpp"
#include "support/catch.hpp"
#include "support/three_cells.hpp"

namespace gvd::test_check_bisectors {

using test::ThreeCells;

using Lines = std::vector<std::string>;

Lines find(const ThreeCells& x) { return x.run(check_bisectors); }

TEST_CASE("the bisectors of a sound diagram have no violation") { CHECK(find(ThreeCells()).empty()); }

TEST_CASE("points, sides, ends and branch points") {
  ThreeCells sides;
  sides.bisector(0).left = sides.bisector(0).right;
  CHECK(find(sides)[0] == "(3) bisector 0: does not separate two cells, or has fewer than two points");
  ThreeCells points;
  std::vector<SurfacePoint>& p = points.bisector(0).points;
  p.erase(p.begin() + 1, p.end() - 1);
  CHECK(find(points) == Lines{"(3) bisector 0: its points 0 and 1 have no face in common"});
  ThreeCells named;
  named.diagram.branch_points[BranchPointId(0)].generators.pop_back();
  CHECK(find(named) == Lines{"(5) branch point 0: its generators are not those of its bisectors"});
}

}  // namespace gvd::test_check_bisectors
