// Nodes and arcs of a grown gap have to fit each other.
#include <functional>
#include <utility>

#include "diagram/growth/check_gap_nodes.hpp"
#include "support/catch.hpp"
#include "support/hand_made_gaps.hpp"

namespace gvd::test_check_gap_nodes {

using test::CornerAndBranch;
using test::HandMade;
using test::TwoAcross;
using test::TwoBranches;

bool check(const HandMade& x) {
  const Crossings crossings = x.crossings();
  return check_gap_nodes(x.mesh, crossings, x.gap, GapEdges(x.mesh, crossings, x.gap, x.grown), x.grown);
}

TEST_CASE("a gap that nothing crosses passes without nodes, and not with a branch point without arcs") {
  HandMade x;
  x.gap.faces = {FaceId(0)};
  CHECK(check(x));
  x.add_branch(FaceId(0), {0.3, 0.3, 0.4});
  CHECK_FALSE(check(x));
}

TEST_CASE("sound nodes pass") {
  CHECK(check(CornerAndBranch()));
  CHECK(check(TwoBranches()));
  CHECK(check(TwoAcross()));
}

TEST_CASE("a rim crossing needs exactly one node, with one arc") {
  TwoAcross no_arc;
  no_arc.grown.arcs.erase(no_arc.grown.arcs.begin());
  CHECK_FALSE(check(no_arc));
  TwoAcross twice;
  twice.grown.nodes[1].rim = twice.grown.nodes[0].rim;
  CHECK_FALSE(check(twice));
  HandMade left_out;
  const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
  left_out.gap.faces = {Mesh::face(left_out.halfedge(a, b))};
  left_out.add_rim(a, b, 0.3, 0, 1);
  left_out.add_rim(a, b, 0.6, 1, 0);
  CHECK_FALSE(check(left_out));
}

TEST_CASE("a new crossing needs an arc in each of its two faces") {
  TwoAcross one_face;
  one_face.grown.arcs[2].face = one_face.below;  // the arc above
  CHECK_FALSE(check(one_face));
  TwoAcross third_arc;
  third_arc.grown.arcs.push_back(GapArc(third_arc.grown.arcs[0]));
  CHECK_FALSE(check(third_arc));
}

TEST_CASE("a new crossing on the mesh's boundary needs one arc") {
  HandMade x;
  const HalfedgeId h = x.halfedge(HandMade::at(0, 0), HandMade::at(1, 0));
  x.gap.faces = {Mesh::face(h)};
  x.add_inside(HandMade::at(0, 0), HandMade::at(1, 0), 0.3, 0, 1);
  x.add_inside(HandMade::at(0, 0), HandMade::at(1, 0), 0.6, 1, 0);
  CHECK_FALSE(check(x));
  x.add_arc(Mesh::face(h), 0, 1, 0, 1);
  CHECK(check(x));
}

TEST_CASE("an arc has the cells of its ends, lies in a face of the gap, and a branch point in its own face") {
  TwoAcross cells;
  std::swap(cells.grown.arcs[0].left, cells.grown.arcs[0].right);
  CHECK_FALSE(check(cells));
  TwoAcross outside;
  outside.grown.arcs[0].face = FaceId(0);
  REQUIRE_FALSE(outside.gap.contains(FaceId(0)));
  CHECK_FALSE(check(outside));
  CornerAndBranch far;
  far.grown.nodes[5].bary = far.at_corners(-0.01, 0.51, 0.5);
  CHECK_FALSE(check(far));
}

}  // namespace gvd::test_check_gap_nodes
