// The edges of a grown gap: which belong to its rim, and which crossings they have.
#include <algorithm>
#include <vector>

#include "diagram/growth/gap_edges.hpp"
#include "support/catch.hpp"
#include "support/hand_made_gaps.hpp"

namespace gvd::test_gap_edges {

using test::HandMade;
using test::TwoAcross;

const GapEdge& find(const GapEdges& edges, EdgeId e) {
  const auto& all = edges.edges();
  return *std::find_if(all.begin(), all.end(), [&](const GapEdge& x) { return x.edge == e; });
}

TEST_CASE("a gap without crossings has its faces' edges, each once, and all of one face are rim inside the mesh") {
  HandMade x;
  const FaceId f = Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)));
  x.gap.faces = {f};
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  REQUIRE(edges.edges().size() == 3);
  for (const GapEdge& e : edges.edges()) {
    CHECK(e.rim);
    CHECK(e.crossings.empty());
  }
  CHECK(edges.rim_crossing_count() == 0);
  CHECK(edges.are_consistent());
}

TEST_CASE("an edge on the mesh's boundary is not part of the rim") {
  HandMade x;
  const HalfedgeId h = x.halfedge(HandMade::at(0, 0), HandMade::at(1, 0));
  REQUIRE(x.mesh.is_boundary(x.mesh.edge(h)));
  x.gap.faces = {Mesh::face(h)};
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  CHECK_FALSE(find(edges, x.mesh.edge(h)).rim);
  CHECK(std::count_if(edges.edges().begin(), edges.edges().end(), [](const GapEdge& e) { return e.rim; }) == 2);
}

TEST_CASE("rim edges keep their crossings, inner edges have those that grew, both ascending") {
  TwoAcross x;
  x.add_rim(x.a, x.c, 0.9, 0, 2);  // from before the growth, on the inner edge: replaced
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  REQUIRE(edges.edges().size() == 5);
  CHECK(std::is_sorted(edges.edges().begin(), edges.edges().end(),
                       [](const GapEdge& a, const GapEdge& b) { return a.edge < b.edge; }));
  CHECK(edges.rim_crossing_count() == 4);
  const GapEdge& inner = find(edges, x.mesh.edge(x.halfedge(x.a, x.c)));
  CHECK_FALSE(inner.rim);
  REQUIRE(inner.crossings.size() == 2);
  CHECK(inner.crossings[0].t < inner.crossings[1].t);
  CHECK(std::max(inner.crossings[0].t, inner.crossings[1].t) < 0.7);
  CHECK(edges.are_consistent());
}

TEST_CASE("crossings too close to each other or to an end, or between cells that do not follow, are inconsistent") {
  const auto consistent = [](double first, double second, int after, int before) {
    HandMade x;
    const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
    x.gap.faces = {Mesh::face(x.halfedge(a, b))};
    x.add_rim(a, b, first, 0, after);
    x.add_rim(a, b, second, before, 0);
    return GapEdges(x.mesh, x.crossings(), x.gap, x.grown).are_consistent();
  };
  CHECK(consistent(0.3, 0.6, 1, 1));
  CHECK_FALSE(consistent(0.3, 0.6, 1, 2));
  CHECK_FALSE(consistent(0.3, 0.3 + 0.5 * kCrossingGap, 1, 1));
  CHECK_FALSE(consistent(0.5 * kCrossingGap, 0.6, 1, 1));
  CHECK_FALSE(consistent(0.3, 1 - 0.5 * kCrossingGap, 1, 1));
}

}  // namespace gvd::test_gap_edges
