// Grown gaps are put into a diagram: crossings get new numbers, arcs and branch points are appended.
#include <algorithm>
#include <vector>

#include "diagram/growth/install_gaps.hpp"
#include "support/catch.hpp"
#include "support/hand_made_gaps.hpp"
#include "support/same_crossings.hpp"

namespace gvd::test_install_gaps {

using test::Fan;
using test::HandMade;
using test::TwoAcross;
using test::TwoBranches;

/// The diagram before the growth, with all of the crossings that a gap made by hand has on its rim.
TracedDiagram before(const HandMade& x) { return {x.labels, x.crossings()}; }

TEST_CASE("without a grown gap nothing changes") {
  const TwoAcross x;
  TracedDiagram traced = before(x);
  install_grown_gaps(x.mesh, {}, traced);
  test::require_same_order(x.crossings(), traced.crossings);
  CHECK(traced.faces.arcs.empty());
  CHECK(traced.moved.empty());
}

TEST_CASE("crossings inside the gap are replaced, and those on its rim keep their arcs") {
  TwoAcross x;
  TracedDiagram traced = before(x);
  const EdgeId inner = x.mesh.edge(x.halfedge(x.a, x.c));
  traced.crossings.replace({inner}, {{inner, 0.9, GeneratorId(0), GeneratorId(2)}});
  for (GapNode& node : x.grown.nodes) {  // the ids of the crossings with that one among them
    if (node.kind != GapNode::Kind::rim) continue;
    const Crossing c = x.crossings()[node.rim];
    const auto& items = traced.crossings.items();
    const auto it = std::find_if(items.begin(), items.end(),
                                 [&](const Crossing& other) { return other.edge == c.edge && other.t == c.t; });
    node.rim = CrossingId(it - items.begin());
  }
  install_grown_gaps(x.mesh, {{x.gap, x.grown, {0}}}, traced);
  CHECK(traced.crossings.size() == 6);
  REQUIRE(traced.crossings.count(inner) == 2);
  CHECK(std::is_sorted(
      traced.crossings.items().begin(), traced.crossings.items().end(),
      [](const Crossing& a, const Crossing& b) { return std::pair(a.edge, a.t) < std::pair(b.edge, b.t); }));
  REQUIRE(traced.faces.arcs.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceArc& arc = traced.faces.arcs[i];
    CHECK(arc.face == x.grown.arcs[i].face);
    REQUIRE((arc.begin.crossing.valid() && arc.end.crossing.valid()));
    // Each end lies on an edge of the arc's face.
    for (const ArcEnd& end : {arc.begin, arc.end}) {
      const HalfedgeId h = x.mesh.halfedge(traced.crossings[end.crossing].edge);
      CHECK((Mesh::face(h) == arc.face || Mesh::face(x.mesh.twin(h)) == arc.face));
    }
  }
}

TEST_CASE("branch points are appended with their distances, and arcs end at them") {
  const TwoBranches x;
  TracedDiagram traced = before(x);
  traced.faces.branches.push_back({FaceId(0), {1, 0, 0}, 5});  // of another gap
  install_grown_gaps(x.mesh, {{x.gap, x.grown, {0}}}, traced);
  REQUIRE(traced.faces.branches.size() == 3);
  CHECK(traced.faces.branches[BranchPointId(1)].face == x.f);
  CHECK(traced.faces.branches[BranchPointId(1)].distance == 1);
  REQUIRE(traced.faces.arcs.size() == 5);
  CHECK(traced.faces.arcs[2].begin == at(BranchPointId(1)));
  CHECK(traced.faces.arcs[2].end == at(BranchPointId(2)));
}

TEST_CASE("vertices that growth moved get their new labels") {
  Fan x;
  x.cross({{x.middle, x.right}, {x.middle, x.at(3, 2)}, {x.middle, x.at(3, 3)}, {x.middle, x.up}});
  REQUIRE(x.check());
  TracedDiagram traced = before(x);
  install_grown_gaps(x.mesh, {{x.gap, x.grown, {0}}}, traced);
  CHECK(traced.moved == std::vector<VertexId>{VertexId(x.middle)});
  CHECK(traced.labels.label[VertexId(x.middle)] == GeneratorId(0));
}

}  // namespace gvd::test_install_gaps
