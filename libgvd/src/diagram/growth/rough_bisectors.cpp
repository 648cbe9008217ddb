// Finds where the rough bisectors (section 4.2) cross the edges, before any unfolding.
//
// The distance of each competing generator is taken at the ends of an edge and at its midpoint, the auxiliary point of
// section 4.1, and is linear between them. The lower envelope of these functions is walked from the first end to the
// last. A crossing lies at each change of the nearest generator.
// Invariant: the crossings of an edge lead from the label of its first vertex to that of its second, whatever the
// tables say, because labels were chosen so that cells are connected.
#include "diagram/growth/rough_bisectors.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "diagram/assembly/form_distances.hpp"
#include "geodesic/marching/local_update.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/vec.hpp"

namespace gvd {
namespace {

/// Number of edges between two reports of progress.
constexpr std::size_t kRoughStride = 1 << 10;

/// Length of the shortest interval of a cell inside an edge, relative to the edge. Marched distances are off by about a
/// hundredth of an edge, so that shorter intervals have no meaning.
constexpr double kShortestRoughInterval = 1e-3;

/// Distances of one generator along an edge: at its first end, its midpoint and its second end.
struct EdgeCandidate {
  GeneratorId generator;
  std::array<double, 3> value{kInfinity, kInfinity, kInfinity};
};

class RoughEdgeEnvelope {
 public:
  explicit RoughEdgeEnvelope(const GrowthInput& input)
      : mesh_(input.mesh()), table_(input.table), labels_(input.labels), front_(input.front) {}

  void find_all(EdgeId e, std::vector<Crossing>& crossings) {
    const auto [first, last] = end_labels(e);
    collect_ends(e);
    if (first == last && !may_have_interval(first, mesh_.length(e))) return;
    collect_midpoints(e);
    trace(e, first, last, crossings);
  }

  /// Appends one crossing between the labels of an edge's ends, or none if the labels are the same.
  void find_at_most_one(EdgeId e, std::vector<Crossing>& crossings) {
    const auto [first, last] = end_labels(e);
    if (first == last) return;
    collect_ends(e);
    collect_midpoints(e);
    std::erase_if(candidates_, [first = first, last = last](const EdgeCandidate& c) {
      return c.generator != first && c.generator != last;
    });
    trace(e, first, last, crossings);
  }

 private:
  std::pair<GeneratorId, GeneratorId> end_labels(EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e);
    return {labels_.label[mesh_.from(h)], labels_.label[mesh_.to(h)]};
  }

  /// Walks the lower envelope of the candidates from cell `first` to cell `last`.
  void trace(EdgeId e, GeneratorId first, GeneratorId last, std::vector<Crossing>& crossings) {
    const GeneratorId middle = nearest(1);
    breaks_.clear();
    walk(0, first, middle);
    walk(1, middle, last);
    emit(e, first, crossings);
  }

  /// Visits the entries of the side's face that are not dominated.
  template <class Visit>
  void for_each_entry(HalfedgeId side, Visit visit) {
    table_.for_each(Mesh::face(side), [&](const TableEntry& entry) {
      if (!entry.dominated) visit(entry);
    });
  }

  /// Makes candidates of the entries of the two faces' tables and of the labels of the two ends.
  void collect_ends(EdgeId e) {
    candidates_.clear();
    const HalfedgeId h = mesh_.halfedge(e);
    for (const HalfedgeId side : {h, mesh_.twin(h)}) {
      if (!side.valid()) continue;
      const int i = Mesh::corner(side);
      for_each_entry(side, [&](const TableEntry& entry) {
        EdgeCandidate& c = candidate(entry.generator);
        const auto d = table_.corner_distances(entry);
        const double from = d[i], to = d[(i + 1) % 3];
        c.value[0] = side == h ? from : to;
        c.value[2] = side == h ? to : from;
      });
    }
    require_label(mesh_.from(h), 0, mesh_.length(e));
    require_label(mesh_.to(h), 2, mesh_.length(e));
  }

  /// Whether another cell could own an interval inside an edge whose two ends belong to `own`. From an end to the
  /// midpoint, a distance changes by at most half the edge's length.
  bool may_have_interval(GeneratorId own, double length) {
    const EdgeCandidate mine = candidate(own);
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const EdgeCandidate& c) {
      return c.generator != own && std::max(c.value[0], c.value[2]) < std::min(mine.value[0], mine.value[2]) + length;
    });
  }

  void collect_midpoints(EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    for (const HalfedgeId side : {h, mesh_.twin(h)}) {
      if (!side.valid()) continue;
      const auto i = static_cast<std::size_t>(Mesh::corner(side));
      const MedianHalves halves = make_median_halves(mesh_.shape(Mesh::face(side)), i);
      for_each_entry(side, [&](const TableEntry& entry) {
        double& middle = candidate(entry.generator).value[1];
        middle = std::min(middle, auxiliary_distance(halves, table_.corner_distances(entry), i, front_));
      });
    }
    for (EdgeCandidate& c : candidates_) {
      // There is a path along the edge from each end to the midpoint.
      c.value[1] = std::min(c.value[1], std::min(c.value[0], c.value[2]) + 0.5 * mesh_.length(e));
      for (double& value : c.value) value = form_value(front_, value);
    }
  }

  EdgeCandidate& candidate(GeneratorId g) {
    for (EdgeCandidate& c : candidates_) {
      if (c.generator == g) return c;
    }
    return candidates_.emplace_back(EdgeCandidate{g});
  }

  /// Makes the label of an end the nearest generator there, whatever the tables say, because labels were chosen so that
  /// cells are connected.
  void require_label(VertexId v, int end, double length) {
    EdgeCandidate& c = candidate(labels_.label[v]);
    double lowest = labels_.distance[v];
    for (const EdgeCandidate& other : candidates_) lowest = std::min(lowest, other.value[end]);
    c.value[end] = lowest;
    c.value[2 - end] = std::min(c.value[2 - end], labels_.distance[v] + length);
  }

  GeneratorId nearest(int sample) const {
    GeneratorId best;
    double least = kInfinity;
    for (const EdgeCandidate& c : candidates_) {
      if (c.value[sample] < least) std::tie(least, best) = std::tuple(c.value[sample], c.generator);
    }
    return best;
  }

  /// Walks the envelope over half `half` (0 or 1) of the edge, on which the candidates' distances are linear.
  void walk(int half, GeneratorId first, GeneratorId last) {
    const double start = 0.5 * half;
    double s = 0;
    for (GeneratorId current = first; current != last;) {
      const EdgeCandidate c = candidate(current);
      double soonest = kInfinity;
      GeneratorId next = last;
      for (const EdgeCandidate& other : candidates_) {
        const double at_start = other.value[half] - c.value[half], at_end = other.value[half + 1] - c.value[half + 1];
        if (other.generator == current || !(at_end < 0 || other.generator == last)) continue;
        const double where = at_start > 0 && at_end < 0 ? at_start / (at_start - at_end) : at_start > 0 ? 1.0 : s;
        // If two candidates cross at the same point, the one that decreases faster is lower beyond it.
        if (std::tuple(where, at_end) < std::tuple(soonest, kInfinity)) {
          soonest = where;
          next = other.generator;
        }
      }
      s = std::max(s, std::min(soonest, 1.0));
      breaks_.emplace_back(start + 0.5 * s, next);
      current = next;
    }
  }

  /// Turns the breaks into crossings, and leaves out intervals inside the edge that are too short. Crossings keep
  /// kCrossingGap from the ends of the edge. The first and the last interval belong to the labels of the ends, and
  /// stay.
  void emit(EdgeId e, GeneratorId first, std::vector<Crossing>& crossings) {
    std::vector<std::pair<double, GeneratorId>> intervals{{0.0, first}};  // (start, generator)
    for (const auto& [t, g] : breaks_) {
      while (intervals.size() > 1 && t - intervals.back().first < kShortestRoughInterval) intervals.pop_back();
      const double start = std::clamp(t, kCrossingGap, 1 - kCrossingGap);
      if (intervals.back().second != g) intervals.emplace_back(start, g);
    }
    for (std::size_t i = 1; i < intervals.size(); ++i) {
      crossings.push_back({e, intervals[i].first, intervals[i - 1].second, intervals[i].second});
    }
  }

  const Mesh& mesh_;
  const GeneratorTable& table_;
  const NearestLabels& labels_;
  Front front_;
  std::vector<EdgeCandidate> candidates_;
  std::vector<std::pair<double, GeneratorId>> breaks_;
};

/// The edges, ascending, of all faces whose corners have different labels, or whose tables have several generators that
/// are not dominated.
std::vector<EdgeId> edges_near_bisectors(const GrowthInput& input) {
  const Mesh& mesh = input.mesh();
  IdVector<EdgeId, char> is_near(mesh.edge_count(), 0);
  for (const FaceId f : mesh.faces()) {
    if (!input.table.reached(f)) continue;
    const auto& [a, b, c] = mesh.vertices(f);
    const bool one_label =
        input.labels.label[a] == input.labels.label[b] && input.labels.label[b] == input.labels.label[c];
    if (one_label && count_competing(input.table, f) <= 1) continue;
    for (const HalfedgeId h : Mesh::halfedges(f)) is_near[mesh.edge(h)] = 1;
  }
  std::vector<EdgeId> edges;
  std::ranges::copy_if(mesh.edges(), std::back_inserter(edges), [&](EdgeId e) { return is_near[e] != 0; });
  return edges;
}

}  // namespace

Crossings find_rough_crossings(const GrowthInput& input, const Progress& progress) {
  std::vector<Crossing> crossings;
  RoughEdgeEnvelope envelope(input);
  const std::vector<EdgeId> edges = edges_near_bisectors(input);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % kRoughStride == 0) report_progress(progress, steps::kCrossings, double(i) / double(edges.size()));
    envelope.find_all(edges[i], crossings);
  }
  return Crossings(input.mesh().edge_count(), std::move(crossings));
}

void cross_at_most_once(const GrowthInput& input, const std::vector<EdgeId>& edges, Crossings& crossings) {
  std::vector<Crossing> single;
  RoughEdgeEnvelope envelope(input);
  for (const EdgeId e : edges) envelope.find_at_most_one(e, single);
  crossings.replace(edges, single);
}

}  // namespace gvd
