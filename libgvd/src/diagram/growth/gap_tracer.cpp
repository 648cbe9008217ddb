// Runs the steps of growth in their order (sections 4.2 and 4.3), and assembles all faces outside the gaps.
//
// Rough crossings are refined and welded, bisectors grow through the gaps, and every other crossed face is closed by
// its own crossings. The paper draws one segment in a face of two labels and leaves the rest to growth; here the
// assembly also completes what growth does not close.
// Invariant: every crossed face is closed exactly once, either by a grown gap or by the assembly. Whether the diagram
// is complete therefore never depends on the growth.
#include "diagram/growth/gap_tracer.hpp"

#include <algorithm>

#include "diagram/growth/assemble_faces.hpp"
#include "diagram/growth/refine_bisectors.hpp"

namespace gvd {
namespace {

/// The faces of grown gaps, ascending.
std::vector<FaceId> faces_of(const std::vector<ClosedGap>& closed) {
  std::vector<FaceId> faces;
  for (const ClosedGap& c : closed) faces.insert(faces.end(), c.gap.faces.begin(), c.gap.faces.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

void GapTracer::close(const std::vector<Gap>& gaps, TracedDiagram& traced) const {
  const GrowthInput growth = input(traced.labels);
  const std::vector<ClosedGap> closed = close_gaps(growth, traced.crossings, gaps, plan_, progress_);
  install_gaps(mesh(), closed, traced);
  assemble_faces(growth, traced.crossings, faces_of(closed), traced.faces, progress_);
  std::ranges::stable_sort(traced.faces.arcs, {}, &FaceArc::face);
  traced.counts.gaps = std::ssize(gaps);
  traced.counts.gaps_grown = 0;
  for (const ClosedGap& c : closed) traced.counts.gaps_grown += std::ssize(c.merged);
}

GrowthTracer::GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front,
                           const Progress& progress)
    : GapTracer(working, table, front, progress, {{GrowthRules::Images::unfolded}, {GrowthRules::Images::rotated}}),
      gaps_(find_gaps(mesh(), table)) {}

Crossings GrowthTracer::cross_edges(const NearestLabels& labels) const {
  return find_rough_crossings(input(labels), progress());
}

void GrowthTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                      Crossings& crossings) const {
  gvd::cross_at_most_once(input(labels), edges, crossings);
}

void GrowthTracer::close_faces(TracedDiagram& traced) {
  // With planar fronts, the rough crossings interpolate distances, and unfolding improves them. With circle fronts,
  // they come from sources that were unfolded over the edge itself, and are the same for both of its faces. Refinement
  // would replace these sources by images that were unfolded over other edges, which is less accurate
  // (docs/developer/performance.md).
  if (front() == Front::planar) {
    weld_crossings(refine_bisectors(input(traced.labels), traced.crossings, progress()), traced.crossings);
  }
  close(gaps_, traced);
}

}  // namespace gvd
