#include <algorithm>
#include <vector>

#include "diagram/graph/disconnected_intervals.hpp"
#include "support/catch.hpp"
#include "support/edge_between.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_disconnected_intervals {

const GeneratorId kOwn(0), kOther(1), kThird(2);

/// Two squares, cut by the edges 0 - 4 and 1 - 5; generator 0 owns all six corners.
struct TwoSquares {
  Mesh mesh = test::make_grid(2, 1);
  NearestLabels labels;

  TwoSquares() {
    labels.label.assign(6, kOwn);
    labels.distance.assign(6, 1.0);
  }

  EdgeId edge(int u, int v) const { return test::edge_between(mesh, u, v); }

  /// Edges with an interval of the other cell in their middle.
  Crossings intervals(std::vector<EdgeId> edges) const {
    std::sort(edges.begin(), edges.end());
    std::vector<Crossing> items;
    for (const EdgeId e : edges) {
      items.push_back({e, 0.4, kOwn, kOther});
      items.push_back({e, 0.6, kOther, kOwn});
    }
    return Crossings(mesh.edge_count(), items);
  }

  std::vector<EdgeId> find(const Crossings& crossings) const {
    return find_disconnected_intervals(mesh, labels, crossings);
  }
};

TEST_CASE("without crossings, and with one on each edge, there is no interval inside an edge") {
  TwoSquares squares;
  CHECK(squares.find(squares.intervals({})).empty());
  squares.labels.label[VertexId(2)] = kOther;
  std::vector<Crossing> items;
  for (int e = 0; e < squares.mesh.edge_count(); ++e) {
    const HalfedgeId h = squares.mesh.halfedge(EdgeId(e));
    const GeneratorId from = squares.labels.label[squares.mesh.from(h)], to = squares.labels.label[squares.mesh.to(h)];
    if (from != to) items.push_back({EdgeId(e), 0.5, from, to});
  }
  REQUIRE(items.size() >= 2);
  CHECK(squares.find(Crossings(squares.mesh.edge_count(), items)).empty());
}

TEST_CASE("a single interval inside an edge is disconnected, on the boundary too") {
  const TwoSquares squares;
  for (const EdgeId e : {squares.edge(1, 4), squares.edge(0, 1)}) {
    CHECK(squares.find(squares.intervals({e})) == std::vector<EdgeId>{e});
  }
}

TEST_CASE("two intervals in one face are connected to each other, and still disconnected from every corner") {
  const TwoSquares squares;
  const EdgeId middle = squares.edge(1, 4), side = squares.edge(0, 1);
  const std::vector<EdgeId> both{std::min(middle, side), std::max(middle, side)};
  CHECK(squares.find(squares.intervals(both)) == both);
}

TEST_CASE("a chain of intervals through common faces connects to a corner of the cell") {
  TwoSquares squares;
  squares.labels.label[VertexId(2)] = kOther;  // has no face in common with the middle edge
  const EdgeId middle = squares.edge(1, 4), between = squares.edge(1, 5);
  CHECK(squares.find(squares.intervals({middle})) == std::vector<EdgeId>{middle});
  CHECK(squares.find(squares.intervals({middle, between})).empty());
}

TEST_CASE("a corner of a third cell does not connect, and an edge with two intervals is named once") {
  TwoSquares squares;
  squares.labels.label[VertexId(2)] = kThird;
  const EdgeId e = squares.edge(1, 4);
  CHECK(squares.find(squares.intervals({e})) == std::vector<EdgeId>{e});
  const Crossings twice(
      squares.mesh.edge_count(),
      {{e, 0.2, kOwn, kOther}, {e, 0.4, kOther, kOwn}, {e, 0.6, kOwn, kThird}, {e, 0.8, kThird, kOwn}});
  // The interval of the cell itself, in between, is connected to the edge's ends.
  CHECK(squares.find(twice) == std::vector<EdgeId>{e});
}

}  // namespace gvd::test_disconnected_intervals
