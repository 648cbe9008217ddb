// Labels whole faces: first with the cell of the largest share, then reduced to one connected component for each label.
//
// Every step keeps the regions connected. A face outside its label's main component loses its label and takes a label
// from an adjacent face, breadth-first from the labelled faces. A generator without a face then takes one, but only
// from a region that stays connected without it. Smoothing (smooth_borders.cpp) follows last and keeps the topology.
// Shares decide between labels, and ids decide between equal shares, so that no result depends on the order of a
// search.
#include "segment_faces.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "region_topology.hpp"
#include "smooth_borders.hpp"

namespace gvd {
namespace {

constexpr const char* kLabelStep = "labels";

/// Sorts ascending faces in which a generator's cell has a share: first the faces that contain the generator, which are
/// added if the cell has no share in them, then all others by share.
void sort_own_faces_first(const Mesh& mesh, const SurfacePoint& generator, std::vector<FaceShare>& candidates) {
  const std::vector<FaceId> own = faces_around(mesh, generator);
  std::vector<FaceId> ascending = own;
  std::sort(ascending.begin(), ascending.end());
  const auto is_own = [&](const FaceShare& s) { return std::ranges::binary_search(ascending, s.face); };
  const std::size_t given = candidates.size();
  for (const FaceId f : own) {  // each occurs once
    const std::span<const FaceShare> shares(candidates.data(), given);
    if (!std::ranges::binary_search(shares, f, {}, &FaceShare::face)) candidates.push_back({f, {}, 0});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](const FaceShare& a, const FaceShare& b) {
    return is_own(a) != is_own(b) ? is_own(a) : a.fraction > b.fraction;
  });
}

/// Removes the label of all faces outside their label's main component, which is the component with a face of the
/// generator or otherwise the one with the largest area. Returns these faces.
std::vector<FaceId> release_minor_components(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                             FaceLabelling& label) {
  const LabelComponents found = find_label_components(mesh, label);
  std::vector<char> holds_generator(found.components.size(), 0);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (const FaceId f : faces_around(mesh, generators[i])) {
      if (label[f] == GeneratorId(i)) holds_generator[found.component[f]] = 1;
    }
  }
  const auto beats = [&](int a, int b) {
    return holds_generator[a] != holds_generator[b] ? holds_generator[a] != 0
                                                    : found.components[a].area > found.components[b].area;
  };
  IdVector<GeneratorId, int> main(generators.size(), -1);
  for (int i = 0; i < std::ssize(found.components); ++i) {
    int& best = main[found.components[i].label];
    if (best < 0 || beats(i, best)) best = i;
  }
  std::vector<FaceId> released;
  for (const FaceId f : mesh.faces()) {
    if (!label[f].valid() || main[label[f]] == found.component[f]) continue;
    label[f] = GeneratorId();
    released.push_back(f);
  }
  return released;
}

/// Labels released faces breadth-first from the labelled ones, so that every label stays connected. Each face takes the
/// adjacent label with the largest share of it; among equal shares, the smallest id wins. Returns their number.
std::int32_t label_released_faces(const Mesh& mesh, const FaceShares& shares, const std::vector<FaceId>& released,
                                  FaceLabelling& label) {
  const auto best_adjacent_label = [&](FaceId f) {
    GeneratorId best;
    for_each_adjacent_face(mesh, f, [&](FaceId g) {
      const GeneratorId other = label[g];
      if (!other.valid()) return;
      const double gain = best.valid() ? shares.fraction(f, other) - shares.fraction(f, best) : 1;
      if (gain > 0 || (gain == 0 && other < best)) best = other;
    });
    return best;
  };
  IdVector<FaceId, char> is_waiting(label.size(), 0);
  std::deque<FaceId> queue;
  for (const FaceId f : released) {
    is_waiting[f] = !best_adjacent_label(f).valid();
    if (!is_waiting[f]) queue.push_back(f);
  }
  std::int32_t moved = 0;
  for (; !queue.empty(); queue.pop_front(), ++moved) {
    const FaceId f = queue.front();
    label[f] = best_adjacent_label(f);
    for_each_adjacent_face(mesh, f, [&](FaceId g) {
      if (std::exchange(is_waiting[g], 0)) queue.push_back(g);
    });
  }
  return moved;
}

}  // namespace

LabelComponents find_label_components(const Mesh& mesh, const FaceLabelling& label) {
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

void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                          const Progress& progress) {
  FaceLabelling& label = result.face_label;
  IdVector<GeneratorId, std::int32_t> count(diagram.generators.size(), 0);  // number of faces of each label
  for (const GeneratorId g : label) {
    if (g.valid()) ++count[g];
  }
  IdVector<GeneratorId, std::vector<FaceShare>> candidates(count.size());
  for (const FaceShare& share : shares.all()) {
    if (count[share.generator] == 0) candidates[share.generator].push_back(share);
  }
  for (const GeneratorId g : count.ids()) {
    if (count[g] > 0) continue;
    report_progress(progress, kLabelStep, 0.5 * g.value() / count.count());
    sort_own_faces_first(mesh, diagram.generators[g.index()], candidates[g]);
  }
  RegionSearch search(mesh, label);
  const auto stays_connected_without = [&](FaceId face) {
    const GeneratorId own = std::exchange(label[face], GeneratorId());
    std::vector<FaceId> beside;
    for_each_adjacent_face(mesh, face, [&](FaceId g) {
      if (label[g] == own) beside.push_back(g);
    });
    const bool connected = beside.size() < 2 || search.connects(beside);
    label[face] = own;
    return connected;
  };
  const auto may_leave = [&](const FaceShare& share) {
    const GeneratorId owner = label[share.face];
    return owner.valid() && count[owner] > 1 && stays_connected_without(share.face);
  };
  for (const GeneratorId g : count.ids()) {
    if (count[g] > 0) continue;
    report_progress(progress, kLabelStep, 0.5 + 0.5 * g.value() / count.count());
    const auto taken = std::ranges::find_if(candidates[g], may_leave);
    if (taken == candidates[g].end()) {
      result.without_face.push_back(g);
      continue;
    }
    --count[label[taken->face]];
    ++count[g];
    label[taken->face] = g;
    ++result.given_faces;
  }
}

Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  check_belongs(mesh, diagram);
  report_progress(options.progress, kLabelStep, 0);
  const FaceShares shares(diagram);
  Segmentation result;
  FaceLabelling& label = result.face_label;
  label = diagram.face_label;
  for (const FaceShare& share : shares.all()) {
    if (!label[share.face].valid()) label[share.face] = share.generator;  // the largest share of a face comes first
  }
  const std::vector<FaceId> released = release_minor_components(mesh, diagram.generators, label);
  result.moved_faces = label_released_faces(mesh, shares, released, label);
  assign_missing_faces(mesh, diagram, shares, result, options.progress);
  if (options.labels == FaceLabels::smooth) smooth_borders(mesh, diagram, shares, result, options.progress);
  return result;
}

}  // namespace gvd
