// Arcs of a grown gap: their order around branch points, and arcs that cross.
#include <utility>

#include "diagram/growth/check_gap_arcs.hpp"
#include "support/catch.hpp"
#include "support/hand_made_gaps.hpp"

namespace gvd::test_check_gap_arcs {

using test::CornerAndBranch;
using test::HandMade;
using test::TwoAcross;
using test::TwoBranches;

bool check(const HandMade& x) { return check_gap_arcs(x.mesh, x.crossings(), x.grown); }

TEST_CASE("no arc, and one arc, are sound") {
  HandMade x;
  CHECK(check(x));
  const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
  x.add_rim(a, b, 0.3, 0, 1);
  x.add_rim(a, b, 0.6, 1, 0);
  x.add_rim_nodes();
  x.add_arc(Mesh::face(x.halfedge(a, b)), 0, 1, 0, 1);
  CHECK(check(x));
}

TEST_CASE("arcs that keep apart or have an end in common are sound") {
  CHECK(check(CornerAndBranch()));
  CHECK(check(TwoBranches()));
  CHECK(check(TwoAcross()));
}

TEST_CASE("two arcs of a face that cross are refused, and arcs of different faces are not compared") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(0.94, 0.03, 0.03);  // beyond the arc that cuts the corner off
  CHECK_FALSE(check(x));
  TwoAcross crossed;
  std::swap(crossed.grown.arcs[0].end, crossed.grown.arcs[1].end);
  CHECK_FALSE(check(crossed));
}

TEST_CASE("a branch point whose cells are in another order than its arcs is refused") {
  TwoBranches swapped;
  std::swap(swapped.grown.arcs[2].left, swapped.grown.arcs[2].right);
  CHECK_FALSE(check(swapped));
  TwoBranches exchanged;  // the two branch points
  std::swap(exchanged.grown.nodes[4].bary, exchanged.grown.nodes[5].bary);
  CHECK_FALSE(check(exchanged));
  TwoBranches missing;
  missing.grown.arcs.pop_back();
  CHECK_FALSE(check(missing));
}

TEST_CASE("one angle at a branch point may exceed half a turn") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(0.1, 0.85, 0.05);  // close to b: one of the three angles is 248 degrees
  CHECK(check(x));
}

}  // namespace gvd::test_check_gap_arcs
