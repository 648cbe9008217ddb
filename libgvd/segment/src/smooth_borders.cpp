#include "smooth_borders.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "adjacent_faces.hpp"
#include "border_costs.hpp"
#include "border_forest.hpp"
#include "free_faces.hpp"
#include "keeps_topology.hpp"

namespace gvd {
namespace {

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
        target_(static_cast<std::size_t>(free.count())),
        least_gain_(kLeastGain * mesh.mean_edge_length()) {}

  void run() {
    for (std::int64_t i = 0; i < kForests; ++i) {
      target_ = forest_.choose(FreeFaceId(i * free_.count() / kForests));
      apply_targets();
    }
    for (int sweep = 0; sweep < kSingleSweeps && relabel_single_faces(); ++sweep) {
    }
  }

 private:
  bool has_target(FreeFaceId i) const { return target_[i] != label_[free_.face(i)]; }

  /// Clusters of connected faces with another target change the border independently of each other.
  void apply_targets() {
    for (std::int32_t i = 0; i < free_.count(); ++i) {
      if (!has_target(FreeFaceId(i))) continue;
      collect_cluster(FreeFaceId(i));
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

  /// Relabels faces one by one as the topology allows, to and fro along the cluster. Keeps as many of these steps as
  /// give the least cost.
  void apply_cluster() {
    steps_.clear();
    sum_ = 0;
    best_ = {-least_gain_, 0};
    waiting_ = cluster_;
    for (int sweep = 0; sweep < kClusterSweeps && take_steps(); ++sweep) std::reverse(waiting_.begin(), waiting_.end());
    for (; steps_.size() > best_.steps; steps_.pop_back()) label_[steps_.back().first] = steps_.back().second;
  }

  /// Whether one of the waiting faces took its target; these wait no longer.
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
    for (std::int32_t i = 0; i < free_.count(); ++i) changed = relabel_single_face(FreeFaceId(i)) || changed;
    return changed;
  }

  /// Gives face i the label of the neighbour that shortens the border most.
  bool relabel_single_face(FreeFaceId i) {
    const FaceId f = free_.face(i);
    GeneratorId best = label_[f];
    double least = -least_gain_;
    for_each_adjacent_face(mesh_, f, [&](FaceId neighbour) {
      const GeneratorId g = label_[neighbour];
      const auto is_g = [g](const FaceShare& share) { return share.generator == g; };
      if (g == label_[f] || std::none_of(free_.candidates(i).begin(), free_.candidates(i).end(), is_g)) return;
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

  // Of the current cluster.
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

void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result) {
  const FreeFaces free(mesh, diagram, shares, result.face_label);
  const IdVector<FaceId, GeneratorId> before = result.face_label;
  BorderSmoother(mesh, free, diagram.generators.size(), result.face_label).run();
  for (std::int32_t i = 0; i < free.count(); ++i) {
    const FaceId f = free.face(FreeFaceId(i));
    result.smoothed_faces += before[f] != result.face_label[f];
  }
}

}  // namespace gvd
