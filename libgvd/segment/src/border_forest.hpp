#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "smooth_borders.hpp"

namespace gvd {

/// Chooses the labels of many free faces at once, by dynamic programming on a forest.
///
/// The free faces, joined where they share a side, are a graph: nearly a path along each bisector. A forest is grown in
/// it breadth-first. A face with two neighbours in the forest stays outside and keeps its label. So faces of the
/// forest share sides with their parent and their children only. The labels of least cost are exact for the forest.
class BorderForest {
 public:
  /// Refers to all arguments. `generators` is the number of labels.
  BorderForest(const FreeFaces& free, const BorderCosts& costs, const IdVector<FaceId, GeneratorId>& label,
               std::size_t generators);

  /// The labels of least cost together; the present ones for faces outside of the forest. The first tree has its root
  /// at `first`, each other one at the next face that is left, in cyclic order. Cost: O(k) for k shares.
  const IdVector<FreeFaceId, GeneratorId>& choose(FreeFaceId first);

 private:
  enum class State : char { waiting, member, outside };
  struct Node {
    State state = State::waiting;
    FreeFaceId parent;       // invalid for a root
    double side = 0;         // length of the sides in common with the parent
    std::span<double> sums;  // for each candidate the least cost of the subtree
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
  std::vector<double> sums_;                  // what the nodes' sums refer to
  std::vector<FreeFaceId> order_;             // the forest's faces, parents before children
  IdVector<GeneratorId, double> child_cost_;  // scratch: for the labels of one child, infinity for all others
  IdVector<FreeFaceId, GeneratorId> chosen_;
};

}  // namespace gvd
