// Shortens the borders between regions: relabels free faces if that lowers the cost and keeps the topology.
//
// Free faces are the faces that bisectors cross, except that one face of each generator keeps its label, so that no
// region vanishes or leaves its generator. The shortest borders are a minimum multiway cut, which is NP-hard with three
// labels or more (E. Dahlhaus et al., The complexity of multiterminal cuts, 1994). The start is a forest (see
// BorderForest). Then the regions expand in turn, until no region gains. Among all sets of free faces that a region can
// take from others, a minimum cut finds the set of least cost (Y. Boykov, O. Veksler and R. Zabih, Fast approximate
// energy minimization via graph cuts, 2001). The cost is submodular in that set. So if no region gains by taking faces
// of others, no two regions gain by an exchange, and with two regions the cost is the least possible.
//
// The cuts do not know topology. Faces with a new label form clusters, which affect the border independently of each
// other. The faces of a cluster change one by one if the topology permits, or all together. Otherwise the steps up to
// the least cost are kept, and a further cut leaves out the faces that could not change. Every kept change lowers the
// cost, so the border never becomes longer. docs/developer/segment-borders.md has the proofs.
#include "smooth_borders.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/least.hpp"
#include "border_forest.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"
#include "min_cut.hpp"
#include "region_topology.hpp"

namespace gvd {
namespace {

/// Marks the face of each generator that keeps its label.
IdVector<FaceId, char> hold_generators(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
                                       const IdVector<FaceId, GeneratorId>& label) {
  IdVector<FaceId, char> held(label.size(), 0);
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const GeneratorId g(i);
    Least<FaceId, std::pair<double, FaceId>> best{{}, {kInfinity, {}}};  // largest share, then smallest id
    for (const FaceId f : faces_around(mesh, diagram.generators[i])) {
      const double fraction = diagram.face_label[f] == g ? 1 : shares.fraction(f, g);
      if (label[f] == g) best.offer({-fraction, f}, f);
    }
    if (best.value.valid()) held[best.value] = 1;
  }
  return held;
}

/// Number of forests before the cuts. With only one, borders of many regions become 0.1 to 0.2 % longer.
constexpr int kForests = 4;

/// Largest number of consecutive cuts for a region, each without the faces that topology held back before. The first
/// cut does nearly all of the work.
constexpr int kCuts = 8;

/// Largest number of sweeps back and forth over the faces of a cluster that wait for their neighbours. Nearly all faces
/// change in the first two; the limit keeps the time linear.
constexpr int kClusterSweeps = 8;

/// The least decrease of the cost that counts, in mean edge lengths. It is far above the rounding of a few sums of
/// lengths.
constexpr double kLeastGain = 1e-9;

/// Capacities are integers, scaled so that the perimeters of all free faces sum to 2^60 to 2^61 units. Costs are at
/// most half of that for borders and kShareWeight of it for shares, so no sum reaches 2^62. Lengths are rounded by at
/// most 2^-61 of the sum.
constexpr int kCapacityBits = 60;

/// Finds by minimum cuts which free faces a region takes from others.
class ExpansionCuts {
 public:
  /// Refers to all arguments, which must outlive this object.
  ExpansionCuts(const Mesh& mesh, const FreeFaces& free, const BorderCosts& costs, const FaceLabelling& label)
      : free_(free), costs_(costs), label_(label), node_(free.count(), kNoNode) {
    double perimeters = 0;
    for (const FreeFaceId i : free.ids()) {
      for (const double side : mesh.shape(free.face(i)).length) perimeters += side;
    }
    if (perimeters > 0) exponent_ = kCapacityBits - std::ilogb(perimeters);
  }

  /// Sets `target` for the faces that region g takes. `candidates` must not have the label g. Among their subsets, the
  /// faces are the subset of least cost, and among several such subsets the smallest.
  void choose(GeneratorId g, std::span<const FreeFaceId> candidates, IdVector<FreeFaceId, GeneratorId>& target) {
    cut_.begin(static_cast<std::int32_t>(candidates.size()));
    for (std::size_t v = 0; v < candidates.size(); ++v) node_[candidates[v]] = static_cast<std::int32_t>(v);
    for (const FreeFaceId i : candidates) add_costs(i, g);
    cut_.run();
    for (const FreeFaceId i : candidates) {
      if (cut_.is_source_side(std::exchange(node_[i], kNoNode))) target[i] = g;
    }
  }

 private:
  static constexpr std::int32_t kNoNode = -1;

  std::int64_t capacity(double cost) const { return std::llround(std::ldexp(cost, exponent_)); }

  /// Adds the costs of face i and its sides for taking label g and for keeping its own. A side between two candidates
  /// is added with the first of them.
  void add_costs(FreeFaceId i, GeneratorId g) {
    const std::int32_t v = node_[i];
    const GeneratorId own = label_[free_.face(i)];
    const auto share = [&](GeneratorId l) { return capacity(costs_.of_share(i, fraction_of(free_.candidates(i), l))); };
    cut_.add_preference(v, share(own) - share(g));
    costs_.for_each_side(i, [&](FaceId f, double length) {
      const FreeFaceId k = free_.find(f);
      const std::int32_t w = k.valid() ? node_[k] : kNoNode;
      const std::int64_t side = capacity(length);
      const bool is_border = label_[f] != own;
      if (w == kNoNode) {
        cut_.add_preference(v, (is_border ? side : 0) - (label_[f] != g ? side : 0));
      } else if (w > v) {
        // A side between different labels costs nothing only if both faces take g.
        if (is_border) cut_.add_preference(v, side);
        cut_.add_edges(v, w, side, is_border ? 0 : side);
      }
    });
  }

  const FreeFaces& free_;
  const BorderCosts& costs_;
  const FaceLabelling& label_;
  MinCut cut_;
  IdVector<FreeFaceId, std::int32_t> node_;  // the node of each candidate
  int exponent_ = 0;                         // a unit of length is 2^exponent_ units of capacity
};

class BorderSmoother {
 public:
  BorderSmoother(const Mesh& mesh, const FreeFaces& free, std::size_t generators, FaceLabelling& label)
      : mesh_(mesh),
        free_(free),
        label_(label),
        costs_(mesh, free, label),
        topology_(mesh, label),
        cuts_(mesh, free, costs_, label),
        faces_of_(generators),
        is_waiting_(generators, 1),
        held_back_(free.count(), 0),
        is_collected_(free.count(), 0),
        least_gain_(kLeastGain * mesh.mean_edge_length()) {
    for (const FreeFaceId i : free.ids()) {
      for (const FaceShare& share : free.candidates(i)) faces_of_[share.generator].push_back(i);
    }
  }

  void run(const Progress& progress) {
    BorderForest forest(free_, costs_, label_, faces_of_.size());
    for (std::int64_t i = 0; i < kForests; ++i) {  // 64 bits, because the product may be large
      report_progress(progress, "borders", 0.5 * double(i) / kForests);
      target_ = forest.choose(FreeFaceId(i * free_.count() / kForests));
      for (const FreeFaceId k : free_.ids()) apply_cluster(k);
    }
    held_back_.assign(held_back_.size(), 0);
    bool changed = true;
    for (double before = 0.5; changed; before = 1) {
      changed = false;
      for (const GeneratorId g : faces_of_.ids()) {
        report_progress(progress, "borders", std::max(before, 0.5 + 0.5 * g.value() / faces_of_.count()));
        if (std::exchange(is_waiting_[g], 0)) changed = expand(g) || changed;
      }
    }
  }

 private:
  GeneratorId label(FreeFaceId i) const { return label_[free_.face(i)]; }

  /// Takes faces for region g from other regions, so that the cost drops as far as possible. Returns whether any label
  /// changed.
  bool expand(GeneratorId g) {
    bool changed = false, complete = false;
    held_back_count_ = 0;
    for (int cut = 0; cut < kCuts && !complete; ++cut) {
      const std::ptrdiff_t before = held_back_count_;
      outside_.clear();
      for (const FreeFaceId i : faces_of_[g]) {
        if (label(i) != g && !held_back_[i]) outside_.push_back(i);
      }
      cuts_.choose(g, outside_, target_);
      for (const FreeFaceId i : outside_) changed = apply_cluster(i) || changed;
      complete = held_back_count_ == before;
    }
    for (const FreeFaceId i : faces_of_[g]) held_back_[i] = 0;
    is_waiting_[g] = changed && held_back_count_ > 0;
    return changed;
  }

  bool has_target(FreeFaceId i) const { return target_[i] != label(i); }

  /// Gives the cluster of face i its targets, as far as that lowers the cost. Returns whether any label changed.
  bool apply_cluster(FreeFaceId i) {
    if (!has_target(i)) return false;
    collect_cluster(i);
    const bool changed = take_best_steps();
    for (const FreeFaceId k : cluster_) target_[k] = label(k);
    return changed;
  }

  /// Collects connected faces whose target differs from their label. They affect the border independently of all other
  /// faces.
  void collect_cluster(FreeFaceId start) {
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

  /// Relabels faces one by one as the topology allows, back and forth along the cluster, and all together if some
  /// remain. If that fails, too, keeps the first steps up to the least cost, and holds the other faces back.
  bool take_best_steps() {
    steps_.clear();
    sum_ = 0;
    best_ = {-least_gain_, 0};
    waiting_ = cluster_;
    for (int sweep = 0; sweep < kClusterSweeps && take_steps(); ++sweep) std::reverse(waiting_.begin(), waiting_.end());
    for (const FreeFaceId i : waiting_) take_step(i);  // only for the sum
    for (FaceChange& step : steps_) {
      const GeneratorId target = label_[step.face];
      topology_.relabel(step.face, step.label);
      step.label = target;
    }
    if (!waiting_.empty() && sum_ < -least_gain_ && topology_.relabel_together(steps_)) {
      waiting_.clear();
    } else {
      steps_.resize(best_.steps);
      for (const FaceChange& step : steps_) topology_.relabel(step.face, step.label);
    }
    for (const FaceChange& step : steps_) mark_regions_round(step.face);
    for (const FreeFaceId i : waiting_) held_back_[i] = 1;
    held_back_count_ += std::ssize(waiting_);
    return !steps_.empty();
  }

  /// Gives waiting faces their targets, if the topology allows it, and removes them from the waiting ones. Returns
  /// whether any face changed.
  bool take_steps() {
    std::size_t left = 0;
    for (const FreeFaceId i : waiting_) {
      if (!topology_.allows(free_.face(i), target_[i])) {
        waiting_[left++] = i;
        continue;
      }
      take_step(i);
      if (sum_ < best_.sum) best_ = {sum_, steps_.size()};
    }
    const bool progress = left < waiting_.size();
    waiting_.resize(left);
    return progress;
  }

  void take_step(FreeFaceId i) {
    sum_ += costs_.change(i, target_[i]);
    steps_.push_back({free_.face(i), label(i)});
    topology_.relabel(free_.face(i), target_[i]);
  }

  /// Marks the regions that may gain now that f has another label: their cells have a share of a face at a vertex of f.
  void mark_regions_round(FaceId f) {
    for (const VertexId v : mesh_.vertices(f)) {
      int faces = 0;
      for_each_face_round(mesh_, v, [&](FaceId g) {
        const FreeFaceId i = free_.find(g);
        if (i.valid()) {
          for (const FaceShare& share : free_.candidates(i)) is_waiting_[share.generator] = 1;
        }
        return ++faces < kLongestFan;
      });
    }
  }

  const Mesh& mesh_;
  const FreeFaces& free_;
  FaceLabelling& label_;
  BorderCosts costs_;
  RegionTopology topology_;
  ExpansionCuts cuts_;
  // For each label, the free faces of which it is a candidate.
  IdVector<GeneratorId, std::vector<FreeFaceId>> faces_of_;
  IdVector<GeneratorId, char> is_waiting_;    // whether a region may gain by an expansion
  IdVector<FreeFaceId, GeneratorId> target_;  // the present label if no change is planned
  std::vector<FreeFaceId> outside_;           // faces that the expanding region may take
  IdVector<FreeFaceId, char> held_back_;      // faces that topology kept from the expanding region
  std::ptrdiff_t held_back_count_ = 0;

  // The current cluster.
  std::vector<FreeFaceId> cluster_, waiting_;
  IdVector<FreeFaceId, char> is_collected_;
  std::vector<FaceChange> steps_;  // the faces relabelled so far, with their previous labels
  double sum_ = 0;                 // change of the cost by all steps so far
  struct {
    double sum;
    std::size_t steps;
  } best_{};  // the least change of the cost after any number of steps, and this number
  double least_gain_;
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

void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                    const Progress& progress) {
  report_progress(progress, "borders", 0);
  const FreeFaces free(mesh, diagram, shares, result.face_label);
  if (free.count() == 0) return;
  const FaceLabelling before = result.face_label;
  BorderSmoother(mesh, free, diagram.generators.size(), result.face_label).run(progress);
  for (const FreeFaceId i : free.ids()) {
    const FaceId f = free.face(i);
    result.smoothed_faces += before[f] != result.face_label[f];
  }
}

}  // namespace gvd
