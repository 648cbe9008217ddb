#pragma once

#include <cstdint>
#include <vector>

namespace gvd {

/// Minimum cuts of sparse graphs with integer capacities.
///
/// Every node lies on one of two sides. A node costs its capacity to the side that it does not lie on; an edge (a, b)
/// costs its capacity if a lies on the source's side and b does not. The sum of all capacities is below 2^62.
class MinCut {
 public:
  /// Begins a graph without edges, of `nodes` nodes without capacities. Cost: O(nodes).
  void begin(std::int32_t nodes);

  /// Adds what node v costs on the sink's side, less what it costs on the source's side.
  void add_preference(std::int32_t v, std::int64_t cost) { excess_[v] += cost; }
  /// Adds edges (a, b) and (b, a) with these capacities.
  void add_edges(std::int32_t a, std::int32_t b, std::int64_t forward, std::int64_t backward);

  /// Finds the cut of least cost; of several, the one with the fewest nodes on the source's side, which is unique.
  /// Without a result within O(n) steps, no node is on the source's side. Adds no more edges after. Cost: O(n) for n
  /// nodes in practice.
  void run();
  bool is_source_side(std::int32_t v) const { return level_[v] >= 0; }

 private:
  struct Arc {
    std::int32_t to, next;  // the next arc from the same node; -1 for none
    std::int64_t capacity;  // that is left
  };

  /// Arcs of augmenting paths for each node, after which `run` gives up. On a ring of 100,000 faces round one vertex
  /// the paths grow so long that the cost would be quadratic: 4 s.
  static constexpr std::int64_t kMostSteps = 200;

  bool find_levels();
  void push_from(std::int32_t source);
  std::int32_t advance(std::int32_t v);
  void push_along_path(std::int32_t source, std::int32_t sink);

  std::vector<Arc> arcs_;                      // arc i ^ 1 is the reverse of arc i
  std::vector<std::int32_t> first_, current_;  // arc of each node: the first one, and the first one not yet in vain
  std::vector<std::int64_t> excess_;  // what the source can still send to a node, or less 0, the node to the sink
  std::vector<std::int32_t> level_;   // arcs from a node with excess; -1 for none
  std::vector<std::int32_t> queue_, path_;
  std::int64_t steps_ = 0;  // arcs of all paths so far
};

}  // namespace gvd
