#include "diagram/growth/grow_gaps.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported once in so many gaps.
constexpr std::size_t kGapStride = 1 << 5;

/// One enlargement in kWholeRing takes all faces around the gap. Ends that miss each other go on for ever if the gap
/// only takes the face before the first of them. Measured on four meshes with 780 gaps: without it 20 stay open, with
/// every third or fourth 5.
constexpr int kWholeRing = 4;

class GapGrower {
 public:
  GapGrower(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
            const GapGrowthPlan& plan)
      : input_(input), mesh_(input.mesh()), crossings_(crossings), plan_(plan) {
    merged_of_.resize(static_cast<std::size_t>(mesh_.face_count()), kNone);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      merged_.push_back({gaps[i], {i}, std::nullopt});
      for (const FaceId f : gaps[i].faces) merged_of_[f] = static_cast<std::int32_t>(i);
    }
  }

  std::vector<ClosedGap> run(const Progress& progress) {
    report_progress(progress, steps::kGrowth, 0);
    for (std::size_t i = 0; i < merged_.size(); ++i) {
      if (i % kGapStride == 0) report_progress(progress, steps::kGrowth, double(i) / double(merged_.size()));
      if (!merged_[i].gap.faces.empty() && !merged_[i].grown) close(i);
    }
    std::vector<ClosedGap> closed;
    for (MergedGap& r : merged_) {
      if (r.grown) closed.push_back({std::move(r.gap), std::move(*r.grown), std::move(r.gaps)});
    }
    return closed;
  }

 private:
  static constexpr std::int32_t kNone = -1;

  /// A gap, or several that were merged; empty if another one took it.
  struct MergedGap {
    Gap gap;
    std::vector<std::size_t> gaps;  // that it contains
    std::optional<GrownGap> grown;
  };

  /// Grows gap `index`, enlarged where needed. The gaps that it takes on the way are kept if that fails.
  void close(std::size_t index) {
    if (merged_[index].gap.faces.size() > kMaxGapFaces) return;
    MergedGap merged{merged_[index].gap, {}, std::nullopt};
    std::vector<std::size_t> taken{index};
    for (int enlargement = 0; merged.gap.faces.size() <= kMaxGapFaces && may_grow(merged.gap); ++enlargement) {
      const FaceId entered = grow(merged);
      if (merged.grown) {
        replace(index, taken, std::move(merged));
        return;
      }
      if (enlargement == plan_.enlargements) return;
      if (entered.valid() && enlargement % kWholeRing != kWholeRing - 1) {
        if (!take({entered}, merged.gap, taken)) return;
      } else {
        if (!take(faces_around(merged.gap), merged.gap, taken)) return;
      }
    }
  }

  /// Tries the rules one after the other. If none of them closes the gap: the face that an end wants to enter, by
  /// the first rule for which there is one.
  FaceId grow(MergedGap& merged) const {
    FaceId entered;
    for (const GrowthRules& rules : plan_.rules) {
      GrowthOutcome outcome = grow_gap(input_, crossings_, merged.gap, rules);
      if (!entered.valid()) entered = outcome.entered;
      merged.grown = std::move(outcome.grown);
      if (merged.grown) break;
    }
    return entered;
  }

  /// Adds faces to a gap, and the whole gaps that they belong to; appends these to `taken`. False if one of them is
  /// too large to grow.
  bool take(const std::vector<FaceId>& faces, Gap& gap, std::vector<std::size_t>& taken) const {
    std::vector<FaceId> added = faces;
    for (const FaceId f : faces) {
      if (merged_of_[f] == kNone) continue;
      const auto other = static_cast<std::size_t>(merged_of_[f]);
      if (std::find(taken.begin(), taken.end(), other) != taken.end()) continue;
      if (merged_[other].gap.faces.size() > kMaxGapFaces) return false;
      taken.push_back(other);
      added.insert(added.end(), merged_[other].gap.faces.begin(), merged_[other].gap.faces.end());
    }
    gap.faces.insert(gap.faces.end(), added.begin(), added.end());
    std::sort(gap.faces.begin(), gap.faces.end());
    gap.faces.erase(std::unique(gap.faces.begin(), gap.faces.end()), gap.faces.end());
    return true;
  }

  /// The faces outside the gap that have an edge in common with it.
  std::vector<FaceId> faces_around(const Gap& gap) const {
    std::vector<FaceId> around;
    for (const FaceId f : gap.faces) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh_.twin(Mesh::halfedge(f, corner));
        if (twin.valid() && !gap.contains(Mesh::face(twin))) around.push_back(Mesh::face(twin));
      }
    }
    return around;
  }

  bool may_grow(const Gap& gap) const {
    return std::none_of(gap.faces.begin(), gap.faces.end(), [&](FaceId f) {
      for (int corner = 0; corner < 3; ++corner) {
        const EdgeId e = mesh_.edge(Mesh::halfedge(f, corner));
        if (std::binary_search(plan_.forbidden.begin(), plan_.forbidden.end(), e)) return true;
      }
      return false;
    });
  }

  /// Puts a grown gap in the place of those that it consists of.
  void replace(std::size_t index, const std::vector<std::size_t>& taken, MergedGap merged) {
    for (const std::size_t t : taken) {
      std::copy(merged_[t].gaps.begin(), merged_[t].gaps.end(), std::back_inserter(merged.gaps));
      merged_[t] = {};
    }
    std::sort(merged.gaps.begin(), merged.gaps.end());
    for (const FaceId f : merged.gap.faces) merged_of_[f] = static_cast<std::int32_t>(index);
    merged_[index] = std::move(merged);
  }

  const GrowthInput& input_;
  const Mesh& mesh_;
  const Crossings& crossings_;
  const GapGrowthPlan& plan_;
  std::vector<MergedGap> merged_;
  IdVector<FaceId, std::int32_t> merged_of_;  // the gap that has the face, or kNone
};

}  // namespace

void GapGrowthPlan::forbid(const std::vector<EdgeId>& edges) {
  std::vector<EdgeId> all;
  std::set_union(edges.begin(), edges.end(), forbidden.begin(), forbidden.end(), std::back_inserter(all));
  forbidden = std::move(all);
}

std::vector<ClosedGap> grow_gaps(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
                                 const GapGrowthPlan& plan, const Progress& progress) {
  return GapGrower(input, crossings, gaps, plan).run(progress);
}

}  // namespace gvd
