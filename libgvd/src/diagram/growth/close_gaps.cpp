// Finds gaps, closes them by growth, and puts the result into the diagram (section 4.3).
//
// A gap is a connected set of faces in which three or more generators compete; two bisectors can only meet in gaps.
// Growth through a gap fails if an end wants to leave it; then the gap takes more faces and starts over. The paper
// stretches ends without a limit; here, a gap that stays open is left to the assembly of faces.
// Invariant: a face belongs to at most one gap at a time. A closed gap therefore replaces all crossings inside its
// faces, and no other gap has these crossings.
#include "diagram/growth/close_gaps.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "base/sort_unique.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// The number of generators that make a face part of a gap. The paper calls a face with three of them a branching
/// triangle, but counts only the labels of its corners (section 3).
constexpr int kGapGenerators = 3;

/// Number of gaps between two reports of progress.
constexpr int kGapStride = 1 << 5;

/// One enlargement in kWholeRing takes all faces around the gap. If the gap only took the face before the first end,
/// ends that miss each other would go on forever (docs/notes/performance.md).
constexpr int kWholeRing = 4;

/// A gap, or several gaps that were merged; empty if another gap took it.
struct MergedGap {
  Gap gap;
  std::vector<int> gaps;  // indices of the given gaps that it contains
  std::optional<GrownGap> grown;
};

/// The gaps, some of which are merged as they grow, and the gap of each face.
class MergedGaps {
 public:
  MergedGaps(const Mesh& mesh, const std::vector<Gap>& gaps) : of_face_(mesh.face_count(), kNone) {
    for (int i = 0; i < std::ssize(gaps); ++i) {
      all.push_back({gaps[i], {i}, std::nullopt});
      for (const FaceId f : gaps[i].faces) of_face_[f] = i;
    }
  }

  /// Adds faces to a gap, and the whole gaps to which these faces belong, whose indices are appended to `taken`.
  /// Returns false if one of these gaps is too large to grow.
  bool take(const std::vector<FaceId>& faces, Gap& gap, std::vector<int>& taken) const {
    std::vector<FaceId> added = faces;
    for (const FaceId f : faces) {
      const int other = of_face_[f];
      if (other == kNone || std::find(taken.begin(), taken.end(), other) != taken.end()) continue;
      if (all[other].gap.faces.size() > kMaxGapFaces) return false;
      taken.push_back(other);
      added.insert(added.end(), all[other].gap.faces.begin(), all[other].gap.faces.end());
    }
    gap.faces.insert(gap.faces.end(), added.begin(), added.end());
    sort_unique(gap.faces);
    return true;
  }

  /// Replaces the gaps that a grown gap took by the grown gap, as gap `index`.
  void replace(int index, const std::vector<int>& taken, Gap gap, GrownGap grown) {
    std::vector<int> contained;
    for (const int t : taken) {
      contained.insert(contained.end(), all[t].gaps.begin(), all[t].gaps.end());
      all[t] = {};
    }
    std::sort(contained.begin(), contained.end());
    for (const FaceId f : gap.faces) of_face_[f] = index;
    all[index] = {std::move(gap), std::move(contained), std::move(grown)};
  }

  std::vector<MergedGap> all;

 private:
  static constexpr int kNone = -1;

  IdVector<FaceId, int> of_face_;  // or kNone
};

/// The faces outside the gap that have an edge in common with it.
std::vector<FaceId> faces_around(const Mesh& mesh, const Gap& gap) {
  std::vector<FaceId> around;
  for (const FaceId f : gap.faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (is_rim(mesh, gap, h)) around.push_back(Mesh::face(mesh.twin(h)));
    }
  }
  return around;
}

/// Whether the gap is small enough to grow, and has no edge where growth is not allowed.
bool may_grow(const Mesh& mesh, const Gap& gap, const std::vector<EdgeId>& forbidden) {
  if (gap.faces.size() > kMaxGapFaces) return false;
  const auto is_forbidden = [&](HalfedgeId h) { return std::ranges::binary_search(forbidden, mesh.edge(h)); };
  return std::ranges::none_of(gap.faces,
                              [&](FaceId f) { return std::ranges::any_of(Mesh::halfedges(f), is_forbidden); });
}

/// Tries the rules one after the other. If none of them closes the gap, returns the face that an end wants to enter,
/// for the first rule for which there is one.
GrowthOutcome grow_by_rules(const GrowthInput& input, const Crossings& crossings, const Gap& gap,
                            const std::vector<GrowthRules>& rules) {
  FaceId entered;
  for (const GrowthRules& rule : rules) {
    GrowthOutcome outcome = grow_bisectors(input, crossings, gap, rule);
    if (outcome.grown) return outcome;
    if (!entered.valid()) entered = outcome.entered;
  }
  return {std::nullopt, entered};
}

/// For each edge, whether all its faces lie in one closed gap. Two gaps never have an edge in common.
IdVector<EdgeId, char> edges_inside(const Mesh& mesh, const std::vector<ClosedGap>& closed) {
  IdVector<EdgeId, char> inside(mesh.edge_count(), 0);
  for (const ClosedGap& c : closed) {
    for (const FaceId f : c.gap.faces) {
      for (const HalfedgeId h : Mesh::halfedges(f)) {
        if (!is_rim(mesh, c.gap, h)) inside[mesh.edge(h)] = 1;
      }
    }
  }
  return inside;
}

/// A crossing of the new diagram, and the place for its new id.
struct NumberedCrossing {
  Crossing crossing;
  CrossingId* id;
};

}  // namespace

std::vector<Gap> connect_gaps(const Mesh& mesh, const IdVector<FaceId, char>& is_in_gap) {
  IdVector<FaceId, char> is_left = is_in_gap;
  std::vector<Gap> gaps;
  for (const FaceId first : mesh.faces()) {
    if (!is_left[first]) continue;
    Gap& gap = gaps.emplace_back(Gap{{first}});
    is_left[first] = 0;
    for (std::size_t k = 0; k < gap.faces.size(); ++k) {
      for (const HalfedgeId h : Mesh::halfedges(gap.faces[k])) {
        const HalfedgeId twin = mesh.twin(h);
        if (!twin.valid() || !is_left[Mesh::face(twin)]) continue;
        is_left[Mesh::face(twin)] = 0;
        gap.faces.push_back(Mesh::face(twin));
      }
    }
    std::sort(gap.faces.begin(), gap.faces.end());
  }
  return gaps;
}

std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table) {
  IdVector<FaceId, char> is_in_gap(mesh.face_count());
  for (const FaceId f : mesh.faces()) is_in_gap[f] = count_competing(table, f) >= kGapGenerators;
  return connect_gaps(mesh, is_in_gap);
}

void ClosingPlan::forbid(const std::vector<EdgeId>& edges) {
  std::vector<EdgeId> all;
  std::set_union(edges.begin(), edges.end(), forbidden.begin(), forbidden.end(), std::back_inserter(all));
  forbidden = std::move(all);
}

std::vector<ClosedGap> close_gaps(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
                                  const ClosingPlan& plan, const Progress& progress) {
  const Mesh& mesh = input.mesh();
  MergedGaps merged(mesh, gaps);
  // Grows gap `index`, and enlarges it as necessary. If that fails, the gaps that it took on the way stay as they were.
  const auto close = [&](int index) {
    Gap gap = merged.all[index].gap;
    std::vector<int> taken{index};
    for (int enlargement = 0; may_grow(mesh, gap, plan.forbidden); ++enlargement) {
      GrowthOutcome outcome = grow_by_rules(input, crossings, gap, plan.rules);
      if (outcome.grown) return merged.replace(index, taken, std::move(gap), std::move(*outcome.grown));
      if (enlargement == plan.enlargements) return;
      const bool whole_ring = !outcome.entered.valid() || enlargement % kWholeRing == kWholeRing - 1;
      if (!merged.take(whole_ring ? faces_around(mesh, gap) : std::vector{outcome.entered}, gap, taken)) return;
    }
  };
  report_progress(progress, steps::kGrowth, 0);
  for (int i = 0; i < std::ssize(gaps); ++i) {
    if (i % kGapStride == 0) report_progress(progress, steps::kGrowth, double(i) / double(gaps.size()));
    if (!merged.all[i].gap.faces.empty() && !merged.all[i].grown) close(i);
  }
  std::vector<ClosedGap> closed;
  for (MergedGap& m : merged.all) {
    if (m.grown) closed.push_back({std::move(m.gap), std::move(*m.grown), std::move(m.gaps)});
  }
  return closed;
}

void install_gaps(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced) {
  // Crossings that stay and crossings that grew are numbered together, ascending by (edge, t).
  IdVector<CrossingId, CrossingId> renamed(traced.crossings.size());  // new ids of crossings that stay
  std::vector<std::vector<CrossingId>> grown_ids(closed.size());  // for each gap and node: ids of crossings that grew
  std::vector<NumberedCrossing> all;
  const IdVector<EdgeId, char> inside = edges_inside(mesh, closed);
  for (const CrossingId id : renamed.ids()) {
    const Crossing& c = traced.crossings[id];
    if (!inside[c.edge]) all.push_back({c, &renamed[id]});
  }
  for (std::size_t c = 0; c < closed.size(); ++c) {
    const std::vector<GapNode>& nodes = closed[c].grown.nodes;
    grown_ids[c].resize(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].kind == GapNode::Kind::crossing) all.push_back({nodes[n].crossing, &grown_ids[c][n]});
    }
  }
  std::ranges::sort(all, {}, [](const NumberedCrossing& c) { return std::tuple(c.crossing.edge, c.crossing.t); });
  std::vector<Crossing> items;
  for (const NumberedCrossing& c : all) {
    *c.id = CrossingId(items.size());
    items.push_back(c.crossing);
  }
  traced.crossings = Crossings(mesh.edge_count(), std::move(items));

  for (std::size_t c = 0; c < closed.size(); ++c) {
    const GrownGap& grown = closed[c].grown;
    std::vector<ArcEnd> ends;  // the nodes
    for (std::size_t n = 0; n < grown.nodes.size(); ++n) {
      const GapNode& node = grown.nodes[n];
      if (node.kind == GapNode::Kind::branch) {
        ends.push_back(at(traced.faces.branches.push_back({node.face, node.bary, node.distance})));
      } else {
        ends.push_back(at(node.kind == GapNode::Kind::rim ? renamed[node.rim] : grown_ids[c][n]));
      }
    }
    for (const GapArc& arc : grown.arcs) {
      traced.faces.arcs.push_back({arc.face, ends[arc.begin], ends[arc.end], arc.left, arc.right});
    }
    for (const auto& [v, g] : grown.labels) {
      traced.labels.label[v] = g;
      traced.moved.push_back(v);
    }
  }
}

}  // namespace gvd
