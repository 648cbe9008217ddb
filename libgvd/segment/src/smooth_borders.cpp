// Short borders between regions: free faces are relabelled where that lowers the cost and keeps the topology.
//
// Free faces are those that bisectors cross. One face of each generator keeps its label, so that no region vanishes and
// none leaves its generator. The shortest borders are a minimum multiway cut, which is NP-hard with three labels or
// more (E. Dahlhaus et al., The complexity of multiterminal cuts, 1994). On a tree it is linear, by dynamic programming
// from the leaves to the root: the least cost of a subtree is needed for each label of its root only. BorderForest
// holds nearly all free faces, because they form paths along the bisectors. No face of it shares a side with another
// one than its parent and its children, so the cost is exact. Faces with a new label form clusters, whose effects on
// the border do not depend on each other. In each cluster the faces change one by one, each only if the topology stays;
// the steps up to the least cost are kept. Four forests with other roots leave other faces outside. Single faces
// follow, until none shortens a border. Every kept change lowers the cost, so the border never becomes longer. See
// docs/developer/segment-borders.md.
#include <algorithm>
#include <utility>

#include "base/least.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"
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

/// A vertex with more faces is not walked round. Without this limit, smoothing round the tip of a cone with n faces
/// would take O(n^2).
constexpr int kLongestFan = 256;

/// Whether test(face) holds for every face round v.
template <class Test>
bool all_faces_round(const Mesh& mesh, VertexId v, Test test) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  for (int i = 0; i < kLongestFan; ++i) {
    if (!test(Mesh::face(h))) return false;
    h = next_outgoing(mesh, h);
    if (!h.valid() || h == start) return true;
  }
  return false;
}

/// The sides of a face behind which a label lies.
struct Sides {
  int count = 0;
  int with = 0;     // the last side with the label
  int without = 0;  // the last side without it
};

/// Forests. The first one takes away nine tenths of what can be, the fourth 0.3 % of the length at most.
constexpr int kForests = 4;

/// Sweeps over the faces of a cluster that wait for their neighbours, and over all free faces one by one. Nearly all
/// changes happen in the first two; the limits keep the time linear.
constexpr int kClusterSweeps = 8, kSingleSweeps = 8;

/// Least decrease of the cost, in mean edge lengths: far above the rounding of a few sums of lengths.
constexpr double kLeastGain = 1e-9;

class BorderSmoother {
 public:
  BorderSmoother(const Mesh& mesh, const FreeFaces& free, std::size_t generators, IdVector<FaceId, GeneratorId>& label)
      : mesh_(mesh),
        free_(free),
        label_(label),
        costs_(mesh, free, label),
        forest_(free, costs_, label, generators),
        target_(free.count()),
        least_gain_(kLeastGain * mesh.mean_edge_length()) {}

  void run(const Progress& progress) {
    for (std::int64_t i = 0; i < kForests; ++i) {  // 64 bits: the product may be large
      report_progress(progress, "borders", double(i) / kForests);
      target_ = forest_.choose(FreeFaceId(i * free_.count() / kForests));
      apply_targets();
    }
    for (int sweep = 0; sweep < kSingleSweeps && relabel_single_faces(); ++sweep)
      report_progress(progress, "borders", 1);
  }

 private:
  bool has_target(FreeFaceId i) const { return target_[i] != label_[free_.face(i)]; }

  /// Clusters of connected faces with another target change the border independently of each other.
  void apply_targets() {
    for (const FreeFaceId i : free_.ids()) {
      if (!has_target(i)) continue;
      collect_cluster(i);
      apply_cluster();
      for (const FreeFaceId k : cluster_) target_[k] = label_[free_.face(k)];
    }
  }

  void collect_cluster(FreeFaceId start) {
    is_collected_.resize(target_.size(), 0);
    cluster_.assign(1, start);
    is_collected_[start] = 1;
    for (std::size_t k = 0; k < cluster_.size(); ++k) {
      for_each_adjacent_face(mesh_, free_.face(cluster_[k]), [&](FaceId f) {
        const FreeFaceId i = free_.find(f);
        if (!i.valid() || is_collected_[i] || !has_target(i)) return;
        is_collected_[i] = 1;
        cluster_.push_back(i);
      });
    }
    for (const FreeFaceId i : cluster_) is_collected_[i] = 0;
  }

  /// Relabels faces one by one as the topology allows, to and fro along the cluster. Keeps the first steps, as many as
  /// give the least cost.
  void apply_cluster() {
    steps_.clear();
    sum_ = 0;
    best_ = {-least_gain_, 0};
    waiting_ = cluster_;
    for (int sweep = 0; sweep < kClusterSweeps && take_steps(); ++sweep) std::reverse(waiting_.begin(), waiting_.end());
    for (; steps_.size() > best_.steps; steps_.pop_back()) label_[steps_.back().first] = steps_.back().second;
  }

  /// Gives waiting faces their targets; these wait no longer. Returns whether there is such a face.
  bool take_steps() {
    std::size_t left = 0;
    for (const FreeFaceId i : waiting_) {
      if (!take_step(i)) waiting_[left++] = i;
    }
    const bool progress = left < waiting_.size();
    waiting_.resize(left);
    return progress;
  }

  bool take_step(FreeFaceId i) {
    const FaceId f = free_.face(i);
    if (!keeps_topology(mesh_, label_, f, target_[i])) return false;
    sum_ += costs_.change(i, target_[i]);
    steps_.push_back({f, label_[f]});
    label_[f] = target_[i];
    if (sum_ < best_.sum) best_ = {sum_, steps_.size()};
    return true;
  }

  bool relabel_single_faces() {
    bool changed = false;
    for (const FreeFaceId i : free_.ids()) changed = relabel_single_face(i) || changed;
    return changed;
  }

  /// Gives face i the label of the neighbour that shortens the border most.
  bool relabel_single_face(FreeFaceId i) {
    const FaceId f = free_.face(i);
    GeneratorId best = label_[f];
    double least = -least_gain_;
    for_each_adjacent_face(mesh_, f, [&](FaceId neighbour) {
      const GeneratorId g = label_[neighbour];
      if (g == label_[f] || fraction_of(free_.candidates(i), g) == 0) return;
      const double change = costs_.change(i, g);
      if (change >= least || !keeps_topology(mesh_, label_, f, g)) return;
      least = change;
      best = g;
    });
    return std::exchange(label_[f], best) != best;
  }

  const Mesh& mesh_;
  const FreeFaces& free_;
  IdVector<FaceId, GeneratorId>& label_;
  BorderCosts costs_;
  BorderForest forest_;
  IdVector<FreeFaceId, GeneratorId> target_;
  double least_gain_;

  // The current cluster.
  std::vector<FreeFaceId> cluster_, waiting_;
  IdVector<FreeFaceId, char> is_collected_;
  std::vector<std::pair<FaceId, GeneratorId>> steps_;  // the faces relabelled so far, and their labels before
  double sum_ = 0;                                     // change of the cost by all steps
  struct {
    double sum;
    std::size_t steps;
  } best_{};  // change of the cost by the first steps, and their number, where it is least
};

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

// The open region of a label is its faces, the edges between them, and the vertices that only they surround. A
// face that leaves changes F - E + V by -1 + 1 if it has one neighbour of its label. With two neighbours it changes by
// -1 + 2 - 1, if the corner between the two sides was inside. In every other case the region falls apart or a hole
// opens. Joining is the same backwards.
bool keeps_topology(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, FaceId f, GeneratorId to) {
  const GeneratorId from = label[f];
  const auto find_sides = [&](GeneratorId g) {
    Sides sides;
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
      const bool same = twin.valid() && label[Mesh::face(twin)] == g;
      sides.count += same;
      (same ? sides.with : sides.without) = corner;
    }
    return sides;
  };
  const auto opposite = [&](int side) { return mesh.opposite(Mesh::halfedge(f, side)); };
  const Sides left = find_sides(from), joined = find_sides(to);
  if (left.count == 0 || left.count == 3 || joined.count == 0) return false;
  if (left.count == 2) {
    const VertexId v = opposite(left.without);
    if (mesh.is_boundary(v) || !all_faces_round(mesh, v, [&](FaceId g) { return label[g] == from; })) return false;
  }
  if (joined.count == 1) {
    return all_faces_round(mesh, opposite(joined.with), [&](FaceId g) { return label[g] != to; });
  }
  const VertexId v = opposite(joined.without);
  return !mesh.is_boundary(v) && all_faces_round(mesh, v, [&](FaceId g) { return g == f || label[g] == to; });
}

void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                    const Progress& progress) {
  const FreeFaces free(mesh, diagram, shares, result.face_label);
  const IdVector<FaceId, GeneratorId> before = result.face_label;
  BorderSmoother(mesh, free, diagram.generators.size(), result.face_label).run(progress);
  for (const FreeFaceId i : free.ids()) {
    const FaceId f = free.face(i);
    result.smoothed_faces += before[f] != result.face_label[f];
  }
}

}  // namespace gvd
