#include "repair/dual_graph.hpp"
#include "support/catch.hpp"

namespace gvd::test_dual_graph {

/// Links are numbered by their halfedges.
std::vector<int> remaining(std::size_t faces, const std::vector<std::array<int, 2>>& links) {
  DualGraph graph(faces);
  int number = 0;
  for (const auto& [a, b] : links) graph.add_link(HalfedgeId(number++), a, b);
  std::vector<int> result;
  for (const HalfedgeId h : graph.prune_leaves()) result.push_back(h.value());
  return result;
}

constexpr int kOut = DualGraph::kOutside;

TEST_CASE("dual graph: without faces, without links, and one face at the border") {
  CHECK(remaining(0, {}).empty());
  CHECK(remaining(3, {}).empty());
  CHECK(remaining(1, {{0, kOut}}).empty());
}

TEST_CASE("dual graph: a tree is pruned whole, whichever order its links have") {
  CHECK(remaining(5, {{0, 1}, {1, 2}, {2, 3}, {2, 4}}).empty());
  CHECK(remaining(5, {{2, 4}, {0, 1}, {2, 3}, {1, 2}}).empty());
  CHECK(remaining(3, {{0, 1}, {1, 2}, {2, kOut}}).empty());  // rooted outside
}

TEST_CASE("dual graph: a cycle remains, its branches do not") {
  CHECK(remaining(6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {3, 5}}) == std::vector<int>{0, 1, 2});
}

TEST_CASE("dual graph: a path between two borders remains, and so does one between two cycles") {
  CHECK(remaining(4, {{kOut, 0}, {0, 1}, {1, kOut}, {1, 2}, {2, 3}}) == std::vector<int>{0, 1, 2});
  CHECK(remaining(7, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 4}}).size() == 8);
}

TEST_CASE("dual graph: pruning does not change the graph") {
  DualGraph graph(3);
  for (const auto& [a, b] : std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}}) graph.add_link({}, a, b);
  CHECK(graph.prune_leaves().size() == 3);
  CHECK(graph.prune_leaves().size() == 3);
  graph.add_link({}, 2, kOut);
  CHECK(graph.prune_leaves().size() == 4);
}

}  // namespace gvd::test_dual_graph
