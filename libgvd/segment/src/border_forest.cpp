// Finds the labels of least cost for a forest of free faces by dynamic programming.
//
// Bisectors cross the free faces, which therefore form paths along the bisectors, and a forest can hold nearly all of
// them. Within the forest, a face shares sides only with its parent and its children, so the least cost of a subtree is
// needed only for each label of its root. Computed from the leaves to the root, that takes linear time for any number
// of labels, and passes through branch points, whereas minimum cuts choose between two labels at a time.
#include "border_forest.hpp"

#include <algorithm>

#include "gvd/vec.hpp"
#include "smooth_borders.hpp"

namespace gvd {

BorderForest::BorderForest(const FreeFaces& free, const BorderCosts& costs, const IdVector<FaceId, GeneratorId>& label,
                           std::size_t generators)
    : free_(free),
      costs_(costs),
      label_(label),
      nodes_(free.count()),
      child_cost_(generators, kInfinity),
      chosen_(nodes_.size()) {
  for (const FreeFaceId i : free.ids()) sums_.resize(sums_.size() + free.candidates(i).size());
  std::span<double> rest(sums_);
  for (const FreeFaceId i : free.ids()) {
    nodes_[i].sums = rest.first(free.candidates(i).size());
    rest = rest.subspan(nodes_[i].sums.size());
  }
}

const IdVector<FreeFaceId, GeneratorId>& BorderForest::choose(FreeFaceId first) {
  order_.clear();
  for (const FreeFaceId i : free_.ids()) {
    nodes_[i].state = State::waiting;
    chosen_[i] = label_[free_.face(i)];
  }
  for (int i = 0; i < free_.count(); ++i) grow(FreeFaceId((first.value() + i) % free_.count()));
  for (const FreeFaceId i : order_) add_own_costs(i);
  for (auto i = order_.rbegin(); i != order_.rend(); ++i) add_to_parent(*i);
  for (const FreeFaceId i : order_) chosen_[i] = best_label(i);
  return chosen_;
}

/// Grows a tree breadth-first from the root, if the root is still waiting.
void BorderForest::grow(FreeFaceId root) {
  if (nodes_[root].state != State::waiting) return;
  nodes_[root].state = State::member;
  nodes_[root].parent = FreeFaceId();
  order_.push_back(root);
  for (std::size_t next = order_.size() - 1; next < order_.size(); ++next) {
    costs_.for_each_side(order_[next], [&](FaceId f, double) {
      const FreeFaceId i = free_.find(f);
      if (i.valid() && nodes_[i].state == State::waiting && join(i)) order_.push_back(i);
    });
  }
}

/// Makes face i the child of its neighbour in the forest, or leaves it outside if it has two such neighbours.
bool BorderForest::join(FreeFaceId i) {
  Node& node = nodes_[i];
  node.state = State::member;
  node.parent = FreeFaceId();
  node.side = 0;
  costs_.for_each_side(i, [&](FaceId f, double length) {
    const FreeFaceId other = free_.find(f);
    if (other == i || !is_member(other)) return;
    if (node.parent.valid() && node.parent != other) node.state = State::outside;
    node.parent = other;
    node.side += length;
  });
  return node.state == State::member;
}

/// Initialises the sums of face i with the costs of its labels and of its borders to faces outside the forest.
void BorderForest::add_own_costs(FreeFaceId i) {
  const auto candidates = free_.candidates(i);
  const std::span<double> sum = nodes_[i].sums;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = costs_.of_share(i, candidates[k].fraction);
  costs_.for_each_side(i, [&](FaceId f, double length) {
    if (is_member(free_.find(f))) return;
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += candidates[k].generator == label_[f] ? 0 : length;
  });
}

/// Adds to each sum of the parent the least cost of i's subtree, either with the parent's label or with their common
/// side as border.
void BorderForest::add_to_parent(FreeFaceId i) {
  const FreeFaceId parent = nodes_[i].parent;
  if (!parent.valid()) return;
  const auto candidates = free_.candidates(i);
  const std::span<double> own = nodes_[i].sums, sum = nodes_[parent].sums;
  for (std::size_t k = 0; k < own.size(); ++k) child_cost_[candidates[k].generator] = own[k];
  const double other = *std::min_element(own.begin(), own.end()) + nodes_[i].side;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] += std::min(other, child_cost_[free_.candidates(parent)[k].generator]);
  }
  for (const FaceShare& share : candidates) child_cost_[share.generator] = kInfinity;
}

/// The best label of face i, given the label of its parent. Among equally good labels, the parent's label comes first,
/// then the label with the largest share.
GeneratorId BorderForest::best_label(FreeFaceId i) const {
  const auto candidates = free_.candidates(i);
  const std::span<const double> sum = nodes_[i].sums;
  const auto least = std::min_element(sum.begin(), sum.end());
  const FreeFaceId parent = nodes_[i].parent;
  for (std::size_t k = 0; parent.valid() && k < sum.size(); ++k) {
    if (candidates[k].generator == chosen_[parent] && sum[k] <= *least + nodes_[i].side) return chosen_[parent];
  }
  return candidates[least - sum.begin()].generator;
}

}  // namespace gvd
