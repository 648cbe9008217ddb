#pragma once

#include <cstdint>
#include <vector>

namespace gvd {

/// Minimum cuts of sparse graphs with integer capacities.
///
/// Every node lies on one of two sides. A node costs its capacity to the side on which it does not lie; an edge (a, b)
/// costs its capacity if a lies on the source's side and b does not. The sum of all capacities must be below 2^62.
class MinCut {
 public:
  /// Begins a new graph with `nodes` nodes, without capacities and edges. Cost: O(nodes).
  void begin(std::int32_t nodes);

  /// Adds to the cost of node v on the sink's side minus its cost on the source's side.
  void add_preference(std::int32_t v, std::int64_t cost) { excess_[v] += cost; }
  /// Adds edges (a, b) and (b, a) with these capacities.
  void add_edges(std::int32_t a, std::int32_t b, std::int64_t forward, std::int64_t backward);

  /// Finds the cut of least cost; among several, the unique one with the fewest nodes on the source's side. If there is
  /// no result within O(n) steps, no node is on the source's side. No edges may be added afterwards. Cost: O(n) for n
  /// nodes in practice.
  void run();
  bool is_source_side(std::int32_t v) const { return level_[v] >= 0; }

 private:
  struct Arc {
    std::int32_t to, next;  // the next arc from the same node; -1 for none
    std::int64_t capacity;  // remaining capacity
  };

  /// `run` gives up after this many arcs of augmenting paths for each node. On a ring of very many faces around a
  /// vertex, paths grow so long that the cost would be quadratic.
  static constexpr std::int64_t kMostSteps = 200;

  bool find_levels();
  void push_from(std::int32_t source);
  std::int32_t advance(std::int32_t v);
  void push_along_path(std::int32_t source, std::int32_t sink);

  std::vector<Arc> arcs_;                      // arc i ^ 1 is the reverse of arc i
  std::vector<std::int32_t> first_, current_;  // for each node, its first arc, and its first arc not yet tried in vain
  std::vector<std::int64_t> excess_;  // what the source can still send to a node or, if negative, the node to the sink
  std::vector<std::int32_t> level_;   // number of arcs from a node with excess; -1 if not reachable
  std::vector<std::int32_t> queue_, path_;
  std::int64_t steps_ = 0;  // number of arcs in all paths so far
};

}  // namespace gvd
