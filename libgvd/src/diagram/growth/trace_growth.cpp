#include "diagram/growth/trace_growth.hpp"

#include "diagram/growth/refine_bisectors.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "diagram/growth/weld_crossings.hpp"

namespace gvd {

GrowthTracer::GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front,
                           const Progress& progress)
    : GrowingTracer(working, table, front, progress, {{GrowthRules::Images::unfolded}, {GrowthRules::Images::rotated}}),
      gaps_(find_gaps(mesh(), table)) {}

Crossings GrowthTracer::cross_edges(const NearestLabels& labels) const {
  return find_rough_crossings(input(labels), progress());
}

void GrowthTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                      Crossings& crossings) const {
  gvd::cross_at_most_once(input(labels), edges, crossings);
}

void GrowthTracer::close_faces(TracedDiagram& traced) const {
  refine(traced);
  close(gaps_, traced);
}

/// With planar fronts the rough crossings interpolate distances, and unfolding improves them. With circles they come
/// from sources that were unfolded over the edge itself, the same for both of its faces. Refinement would replace these
/// by images that were unfolded over other edges, which is less accurate (docs/developer/performance.md has figures).
void GrowthTracer::refine(TracedDiagram& traced) const {
  if (front() == Front::circle) return;
  weld_crossings(refine_bisectors(input(traced.labels), traced.crossings, progress()), traced.crossings);
}

}  // namespace gvd
