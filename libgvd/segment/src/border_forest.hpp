#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "smooth_borders.hpp"

namespace gvd {

/// Chooses the labels of many free faces at once, by dynamic programming on a forest.
///
/// The free faces form a graph, in which faces with a common side are neighbours; along a bisector it is nearly a path.
/// The forest grows in this graph breadth-first. A face with two neighbours in the forest stays outside and keeps its
/// label. So faces of the forest share sides only with their parent and their children, and the labels of least cost
/// are exact for the forest.
class BorderForest {
 public:
  /// Refers to all arguments. `generators` is the number of labels.
  BorderForest(const FreeFaces& free, const BorderCosts& costs, const IdVector<FaceId, GeneratorId>& label,
               std::size_t generators);

  /// Returns the labels of least total cost; faces outside the forest keep their present labels. The first tree has its
  /// root at `first`, and each further tree at the next remaining face in cyclic order. Cost: O(k) for k shares.
  const IdVector<FreeFaceId, GeneratorId>& choose(FreeFaceId first);

 private:
  enum class State : char { waiting, member, outside };
  struct Node {
    State state = State::waiting;
    FreeFaceId parent;       // invalid for a root
    double side = 0;         // length of the sides shared with the parent
    std::span<double> sums;  // for each candidate label, the least cost of the subtree
  };

  void grow(FreeFaceId root);
  bool join(FreeFaceId i);
  void add_own_costs(FreeFaceId i);
  void add_to_parent(FreeFaceId i);
  GeneratorId best_label(FreeFaceId i) const;

  bool is_member(FreeFaceId i) const { return i.valid() && nodes_[i].state == State::member; }

  const FreeFaces& free_;
  const BorderCosts& costs_;
  const IdVector<FaceId, GeneratorId>& label_;
  IdVector<FreeFaceId, Node> nodes_;
  std::vector<double> sums_;                  // the memory of all nodes' sums
  std::vector<FreeFaceId> order_;             // the forest's faces, parents before children
  IdVector<GeneratorId, double> child_cost_;  // temporary: the costs of one child's labels; infinity for other labels
  IdVector<FreeFaceId, GeneratorId> chosen_;
};

}  // namespace gvd
