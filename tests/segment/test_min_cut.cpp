#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "min_cut.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_min_cut {

/// A graph as its definition has it.
struct Graph {
  struct Edge {
    int a, b;
    std::int64_t forward, backward;
  };
  std::vector<std::int64_t> preference;
  std::vector<Edge> edges;

  /// The cost of the cut whose source's side is this set of bits, less what every cut costs.
  std::int64_t cost(unsigned source_side) const {
    const auto has = [&](int v) { return (source_side >> v & 1) != 0; };
    std::int64_t sum = 0;
    for (int v = 0; v < std::ssize(preference); ++v) sum += has(v) ? -preference[v] : 0;
    for (const Edge& e : edges) {
      if (has(e.a) && !has(e.b)) sum += e.forward;
      if (has(e.b) && !has(e.a)) sum += e.backward;
    }
    return sum;
  }

  unsigned cut(MinCut& cut) const {
    const int nodes = static_cast<int>(preference.size());
    cut.begin(nodes);
    for (int v = 0; v < nodes; ++v) cut.add_preference(v, preference[v]);
    for (const Edge& e : edges) cut.add_edges(e.a, e.b, e.forward, e.backward);
    cut.run();
    unsigned side = 0;
    for (int v = 0; v < nodes; ++v) side |= unsigned(cut.is_source_side(v)) << v;
    return side;
  }
};

/// Tries all cuts.
void require_least(const Graph& graph, unsigned found) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  unsigned common = ~0u;
  for (unsigned side = 0; side < 1u << graph.preference.size(); ++side) {
    const std::int64_t cost = graph.cost(side);
    common = cost < least ? side : cost == least ? common & side : common;
    least = std::min(least, cost);
  }
  REQUIRE(graph.cost(found) == least);
  REQUIRE(found == common);  // the intersection of minimum cuts is one of them, the smallest
}

Graph make_random_graph(int nodes, std::int64_t most, unsigned seed) {
  test::Random random(seed);
  const auto capacity = [&] { return most / 8 * random.below(9); };  // few values, so that many cuts are equal
  Graph graph;
  for (int v = 0; v < nodes; ++v) graph.preference.push_back(capacity() - capacity());
  for (int e = random.below(2 * nodes + 1); e > 0 && nodes > 1; --e) {
    const int a = random.below(nodes), b = (a + 1 + random.below(nodes - 1)) % nodes;
    graph.edges.push_back({a, b, capacity(), random.below(2) == 0 ? 0 : capacity()});
  }
  return graph;
}

TEST_CASE("minimum cut: the smallest graphs") {
  MinCut cut;
  cut.begin(0);
  cut.run();
  CHECK(Graph{{0}, {}}.cut(cut) == 0);
  CHECK(Graph{{1}, {}}.cut(cut) == 1);
  CHECK(Graph{{-1}, {}}.cut(cut) == 0);
  CHECK(Graph{{5, -3}, {{0, 1, 2, 0}}}.cut(cut) == 1);                // the edge is cheaper
  CHECK(Graph{{5, -3}, {{0, 1, 4, 0}}}.cut(cut) == 3);                // node 1 changes its side
  CHECK(Graph{{3, -3}, {{0, 1, 4, 0}}}.cut(cut) == 0);                // of two cuts with cost 3, the smaller one
  CHECK(Graph{{5, -3}, {{1, 0, 4, 0}}}.cut(cut) == 1);                // an edge to the source's side costs nothing
  CHECK(Graph{{5, -3}, {{0, 1, 1, 0}, {0, 1, 3, 0}}}.cut(cut) == 3);  // parallel edges
}

TEST_CASE("minimum cut: the least of all, and the smallest of these") {
  MinCut cut;  // the same one for all graphs: nothing stays from the last one
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const Graph graph = make_random_graph(1 + static_cast<int>(seed % 10), std::int64_t{1} << 54, seed);
    require_least(graph, graph.cut(cut));
  }
}

TEST_CASE("minimum cut: a path of many nodes") {
  constexpr std::int32_t kNodes = 50000, kWeakest = 34567;
  MinCut cut;
  cut.begin(kNodes);
  cut.add_preference(0, 1000);
  cut.add_preference(kNodes - 1, -1000);
  for (std::int32_t v = 0; v + 1 < kNodes; ++v) cut.add_edges(v, v + 1, v == kWeakest ? 7 : 8 + v % 5, 8);
  cut.run();
  CHECK(cut.is_source_side(kWeakest));
  CHECK_FALSE(cut.is_source_side(kWeakest + 1));
}

/// The sides of a path of 600 nodes, whose weakest edge is in its middle and whose last node prefers the sink. So many
/// further nodes prefer the source, each joined to the path's first node: every one takes an augmenting path of its
/// own, as long as the whole path.
std::vector<bool> cut_comb(MinCut& cut, std::int32_t sources) {
  constexpr std::int32_t kPath = 600, kWeakest = 300;
  cut.begin(kPath + sources);
  for (std::int32_t v = 0; v + 1 < kPath; ++v) cut.add_edges(v, v + 1, v == kWeakest ? sources - 1 : sources + 1, 0);
  cut.add_preference(kPath - 1, -2 * sources);
  for (std::int32_t v = kPath; v < kPath + sources; ++v) {
    cut.add_preference(v, 1);
    cut.add_edges(v, 0, 1, 0);
  }
  cut.run();
  std::vector<bool> side;
  for (std::int32_t v = 0; v < kPath + sources; ++v) side.push_back(cut.is_source_side(v));
  return side;
}

TEST_CASE("minimum cut: where paths are too many and too long, no node changes its side, and the next graph is cut") {
  MinCut cut;
  const auto on_source_side = [&](std::int32_t sources) {
    const std::vector<bool> side = cut_comb(cut, sources);
    return std::count(side.begin(), side.end(), true);
  };
  CHECK(on_source_side(100) == 301 + 100);  // 60,000 arcs for 700 nodes; the weakest edge is cut
  CHECK(on_source_side(3000) == 0);         // 1,800,000 for 3600
  CHECK(on_source_side(100) == 301 + 100);
}

}  // namespace gvd::test_min_cut
