#include "diagram/growth/trace_growth.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "diagram/growth/assemble_faces.hpp"
#include "diagram/growth/growth.hpp"
#include "diagram/growth/install_gaps.hpp"
#include "diagram/growth/refine_bisectors.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "diagram/growth/weld_crossings.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported once in so many gaps.
constexpr std::size_t kProgressStride = 1 << 5;

}  // namespace

GrowthTracer::GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front,
                           const Progress& progress)
    : working_(working),
      mesh_(working.mesh()),
      table_(table),
      front_(front),
      progress_(progress),
      gaps_(find_gaps(mesh_, table)),
      may_grow_(gaps_.size(), 1) {}

Crossings GrowthTracer::cross_edges(const NearestLabels& labels) const {
  return find_rough_crossings(input(labels), progress_);
}

void GrowthTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                      Crossings& crossings) const {
  gvd::cross_at_most_once(input(labels), edges, crossings);
}

void GrowthTracer::close_faces(TracedDiagram& traced) {
  refine(traced);
  grow(traced);
  assemble_rest(traced);
}

void GrowthTracer::disable_growth(const std::vector<EdgeId>& edges) {
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (may_grow_[i] && has_edge(gaps_[i], edges)) may_grow_[i] = 0;
  }
}

/// With planar fronts the rough crossings interpolate distances, and unfolding improves them. With circles they come
/// from sources that were unfolded over the edge itself, the same for both of its faces. Refinement would replace these
/// by images that were unfolded over other edges, which is less accurate (docs/developer/performance.md has figures).
void GrowthTracer::refine(TracedDiagram& traced) const {
  if (front_ == Front::circle) return;
  weld_crossings(refine_bisectors(input(traced.labels), traced.crossings, progress_), traced.crossings);
}

/// Grows every gap that may; counts those that close.
void GrowthTracer::grow(TracedDiagram& traced) {
  std::vector<ClosedGap> closed;
  report_progress(progress_, steps::kGrowth, 0);
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (!may_grow_[i]) continue;
    if (i % kProgressStride == 0) report_progress(progress_, steps::kGrowth, double(i) / double(gaps_.size()));
    auto grown = grow_gap(input(traced.labels), traced.crossings, gaps_[i]);
    if (grown) closed.push_back({&gaps_[i], std::move(*grown)});
    may_grow_[i] = grown.has_value();
  }
  install_grown_gaps(mesh_, closed, traced);
  traced.counts.gaps = static_cast<std::int64_t>(gaps_.size());
  traced.counts.gaps_grown = static_cast<std::int64_t>(closed.size());
}

/// Assembles the faces outside of grown gaps, and sorts all arcs by face.
void GrowthTracer::assemble_rest(TracedDiagram& traced) const {
  std::vector<FaceId> grown;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (may_grow_[i]) grown.insert(grown.end(), gaps_[i].faces.begin(), gaps_[i].faces.end());
  }
  std::sort(grown.begin(), grown.end());
  assemble_faces(input(traced.labels), traced.crossings, grown, traced.faces, progress_);
  std::stable_sort(traced.faces.arcs.begin(), traced.faces.arcs.end(),
                   [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; });
}

bool GrowthTracer::has_edge(const Gap& gap, const std::vector<EdgeId>& edges) const {
  return std::any_of(gap.faces.begin(), gap.faces.end(), [&](FaceId f) {
    for (int corner = 0; corner < 3; ++corner) {
      if (std::binary_search(edges.begin(), edges.end(), mesh_.edge(Mesh::halfedge(f, corner)))) return true;
    }
    return false;
  });
}

}  // namespace gvd
