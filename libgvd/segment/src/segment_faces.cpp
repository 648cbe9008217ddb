// Labels of whole faces: the cell with the largest share, then one connected component for each label.
//
// Every step keeps the regions connected. A face outside of its label's main component loses its label, and takes one
// from an adjacent face, breadth-first from the labelled faces. A generator without a face then takes one, but only
// from a region that stays connected without it. Smoothing (smooth_borders.cpp) follows last and keeps the topology.
// Shares decide between labels, and ids where shares are equal, so that no result depends on the order of a search.
#include <algorithm>
#include <deque>
#include <utility>

#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "label_components.hpp"
#include "region_topology.hpp"
#include "smooth_borders.hpp"

namespace gvd {

LabelComponents find_label_components(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label) {
  LabelComponents result;
  result.component.assign(label.size(), -1);
  std::vector<FaceId> stack;
  for (const FaceId start : mesh.faces()) {
    if (result.component[start] >= 0 || !label[start].valid()) continue;
    const auto number = static_cast<std::int32_t>(result.components.size());
    result.components.push_back({label[start]});
    result.component[start] = number;
    for (stack.assign(1, start); !stack.empty();) {
      const FaceId f = stack.back();
      stack.pop_back();
      result.components.back().area += mesh.area(f);
      for_each_adjacent_face(mesh, f, [&](FaceId g) {
        if (result.component[g] >= 0 || label[g] != label[f]) return;
        result.component[g] = number;
        stack.push_back(g);
      });
    }
  }
  return result;
}

namespace {

/// Finds faces for the generators without one.
class FaceAssigner {
 public:
  FaceAssigner(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
               const Progress& progress)
      : mesh_(mesh),
        diagram_(diagram),
        shares_(shares),
        result_(result),
        progress_(progress),
        count_(diagram.generators.size(), 0),
        search_(mesh, result.face_label) {
    for (const GeneratorId g : result.face_label) {
      if (g.valid()) ++count_[g];
    }
  }

  void run() {
    const auto candidates = collect_candidates();
    for (const GeneratorId generator : count_.ids()) {
      if (count_[generator] > 0) continue;
      report(0.5 + 0.5 * generator.value() / count_.count());
      const FaceId face = find_face(candidates[generator]);
      if (!face.valid()) {
        result_.without_face.push_back(generator);
        continue;
      }
      --count_[label(face)];
      ++count_[generator];
      result_.face_label[face] = generator;
      ++result_.given_faces;
    }
  }

 private:
  using Candidates = IdVector<GeneratorId, std::vector<FaceShare>>;

  GeneratorId label(FaceId f) const { return result_.face_label[f]; }

  void report(double fraction) const { report_progress(progress_, "labels", fraction); }

  Candidates collect_candidates() const {
    Candidates candidates(count_.size());
    for (const FaceShare& share : shares_.all()) {
      if (count_[share.generator] == 0) candidates[share.generator].push_back(share);
    }
    for (const GeneratorId g : count_.ids()) {
      if (count_[g] > 0) continue;
      report(0.5 * g.value() / count_.count());
      sort_own_faces_first(diagram_.generators[g.index()], candidates[g]);
    }
    return candidates;
  }

  void sort_own_faces_first(const SurfacePoint& generator, std::vector<FaceShare>& candidates) const {
    const std::vector<FaceId> own = faces_around(mesh_, generator);
    std::vector<FaceId> ascending = own;
    std::sort(ascending.begin(), ascending.end());
    const auto is_own = [&](const FaceShare& s) { return std::ranges::binary_search(ascending, s.face); };
    // The shares of one cell ascend by face, and each face of `own` comes once.
    const std::size_t given = candidates.size();
    for (const FaceId f : own) {
      const std::span<const FaceShare> shares(candidates.data(), given);
      if (!std::ranges::binary_search(shares, f, {}, &FaceShare::face)) candidates.push_back({f, {}, 0});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [&](const FaceShare& a, const FaceShare& b) {
      return is_own(a) != is_own(b) ? is_own(a) : a.fraction > b.fraction;
    });
  }

  FaceId find_face(const std::vector<FaceShare>& candidates) {
    for (const FaceShare& share : candidates) {
      const GeneratorId generator = label(share.face);
      if (generator.valid() && count_[generator] > 1 && stays_connected_without(share.face)) return share.face;
    }
    return FaceId();
  }

  /// Whether the adjacent faces with the label of `face` are connected without it.
  bool stays_connected_without(FaceId face) {
    const GeneratorId own = std::exchange(result_.face_label[face], GeneratorId());
    std::vector<FaceId> targets;
    for_each_adjacent_face(mesh_, face, [&](FaceId g) {
      if (label(g) == own) targets.push_back(g);
    });
    const bool connected = targets.size() < 2 || search_.connects(targets);
    result_.face_label[face] = own;
    return connected;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const FaceShares& shares_;
  Segmentation& result_;
  const Progress& progress_;
  IdVector<GeneratorId, std::int32_t> count_;  // faces of each label
  RegionSearch search_;
};

/// Labels the faces by their largest shares, and makes every label connected.
class FaceLabeller {
 public:
  FaceLabeller(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares)
      : mesh_(mesh), diagram_(diagram), shares_(shares) {}

  Segmentation run() {
    label_by_area();
    release_minor_components();
    label_released_faces();
    return std::move(result_);
  }

 private:
  GeneratorId& label(FaceId f) { return result_.face_label[f]; }

  void label_by_area() {
    result_.face_label = diagram_.face_label;
    for (const FaceShare& share : shares_.all()) {
      if (!label(share.face).valid()) label(share.face) = share.generator;  // the largest share of a face comes first
    }
  }

  /// Takes the label from all faces outside of their label's main component: the one with a face of the generator, or
  /// else the one with the largest area.
  void release_minor_components() {
    const LabelComponents found = find_label_components(mesh_, result_.face_label);
    const std::vector<char> holds_generator = mark_components_of_generators(found);
    const auto beats = [&](int a, int b) {
      return holds_generator[a] != holds_generator[b] ? holds_generator[a] != 0
                                                      : found.components[a].area > found.components[b].area;
    };
    IdVector<GeneratorId, int> main(diagram_.generators.size(), -1);
    for (int i = 0; i < std::ssize(found.components); ++i) {
      int& best = main[found.components[i].label];
      if (best < 0 || beats(i, best)) best = i;
    }
    for (const FaceId f : mesh_.faces()) {
      if (!label(f).valid() || main[label(f)] == found.component[f]) continue;
      label(f) = GeneratorId();
      released_.push_back(f);
    }
  }

  std::vector<char> mark_components_of_generators(const LabelComponents& found) {
    std::vector<char> marked(found.components.size(), 0);
    for (std::size_t i = 0; i < diagram_.generators.size(); ++i) {
      for (const FaceId f : faces_around(mesh_, diagram_.generators[i])) {
        if (label(f) == GeneratorId(i)) marked[found.component[f]] = 1;
      }
    }
    return marked;
  }

  /// Labels breadth-first from the labelled faces. Each released face takes the label of an adjacent face, so every
  /// label stays connected.
  void label_released_faces() {
    IdVector<FaceId, char> is_waiting(result_.face_label.size(), 0);
    std::deque<FaceId> queue;
    for (const FaceId f : released_) {
      is_waiting[f] = !best_adjacent_label(f).valid();
      if (!is_waiting[f]) queue.push_back(f);
    }
    for (; !queue.empty(); queue.pop_front()) {
      const FaceId f = queue.front();
      label(f) = best_adjacent_label(f);
      ++result_.moved_faces;
      for_each_adjacent_face(mesh_, f, [&](FaceId g) {
        if (!is_waiting[g]) return;
        is_waiting[g] = 0;
        queue.push_back(g);
      });
    }
  }

  /// The adjacent label with the largest share of the face, the smallest id among equals; none if no face has a label.
  GeneratorId best_adjacent_label(FaceId f) {
    GeneratorId best;
    for_each_adjacent_face(mesh_, f, [&](FaceId g) {
      const GeneratorId other = label(g);
      if (!other.valid()) return;
      const double gain = best.valid() ? shares_.fraction(f, other) - shares_.fraction(f, best) : 1;
      if (gain > 0 || (gain == 0 && other < best)) best = other;
    });
    return best;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const FaceShares& shares_;
  std::vector<FaceId> released_;
  Segmentation result_;
};

}  // namespace

void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                          const Progress& progress) {
  FaceAssigner(mesh, diagram, shares, result, progress).run();
}

Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  check_belongs(mesh, diagram);
  report_progress(options.progress, "labels", 0);
  const FaceShares shares(diagram);
  Segmentation result = FaceLabeller(mesh, diagram, shares).run();
  assign_missing_faces(mesh, diagram, shares, result, options.progress);
  if (options.labels == FaceLabels::smooth) smooth_borders(mesh, diagram, shares, result, options.progress);
  return result;
}

}  // namespace gvd
