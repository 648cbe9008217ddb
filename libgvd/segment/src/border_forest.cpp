// Labels of least cost for many free faces at once, by dynamic programming from the leaves of a forest to its roots.
//
// Free faces are those that bisectors cross. One face of each generator keeps its label, so that no region vanishes and
// none leaves its generator.
// The shortest borders are a minimum multiway cut, which is NP-hard with three labels or more (E. Dahlhaus et al., The
// complexity of multiterminal cuts, 1994). On a tree it is linear: the least cost of a subtree is needed for each label
// of its root only. The forest holds nearly all free faces, because they form paths along the bisectors. No face of the
// forest shares a side with another one than its parent and its children, so the cost is exact. See
// docs/developer/segment-borders.md.
#include "base/least.hpp"
#include "gvd/surface_point.hpp"
#include "segment_steps.hpp"

namespace gvd {
namespace {

/// Marks the face of each generator that keeps its label.
IdVector<FaceId, char> hold_generators(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
                                       const IdVector<FaceId, GeneratorId>& label) {
  IdVector<FaceId, char> held(label.size(), 0);
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const GeneratorId g(i);
    Least<FaceId, std::pair<double, FaceId>> best{{}, {kInfinity, {}}};  // of the largest share, the smallest id
    for (const FaceId f : faces_around(mesh, diagram.generators[i])) {
      const double fraction = diagram.face_label[f] == g ? 1 : shares.fraction(f, g);
      if (label[f] == g) best.offer({-fraction, f}, f);
    }
    if (best.value.valid()) held[best.value] = 1;
  }
  return held;
}

}  // namespace

FreeFaces::FreeFaces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
                     const IdVector<FaceId, GeneratorId>& label)
    : id_(mesh.face_count()) {
  const IdVector<FaceId, char> held = hold_generators(mesh, diagram, shares, label);
  const std::span all(shares.all());
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    const FaceId f = all[first].face;
    std::size_t owners = 0;
    for (; last < all.size() && all[last].face == f; ++last) owners += all[last].fraction > 0;
    if (owners < 2 || held[f]) continue;
    const auto candidates = all.subspan(first, owners);
    id_[f] = faces_.push_back({f, candidates, fraction_of(candidates, label[f])});
  }
}

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

/// Grows a tree breadth-first from the root, if the root waits.
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

/// Makes face i the child of its neighbour in the forest, or leaves it outside if it has two.
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

/// Sets the sums of face i to what its labels cost with its neighbours outside of the forest.
void BorderForest::add_own_costs(FreeFaceId i) {
  const auto candidates = free_.candidates(i);
  const std::span<double> sum = nodes_[i].sums;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = costs_.of_share(i, candidates[k].fraction);
  costs_.for_each_side(i, [&](FaceId f, double length) {
    if (is_member(free_.find(f))) return;
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += candidates[k].generator == label_[f] ? 0 : length;
  });
}

/// Adds to each sum of the parent the least cost of i's subtree: with the same label, or with the side as border.
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

/// The best label of face i, given that of its parent. Among equally good ones the parent's comes first, then that of
/// the largest share.
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
