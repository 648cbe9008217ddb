#include "diagram/growth/trace_growth.hpp"

#include "diagram/growth/close_gaps.hpp"
#include "diagram/growth/refine_bisectors.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "diagram/growth/weld_crossings.hpp"

namespace gvd {
namespace {

/// How often a gap that does not close is enlarged. Measured on four meshes with 780 gaps: of 95 that do not close at
/// first, 9 stay open with 6, 5 with 10 and 2 with 20, at up to four times the time.
constexpr int kEnlargements = 10;

}  // namespace

GrowthTracer::GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front,
                           const Progress& progress)
    : working_(working),
      mesh_(working.mesh()),
      table_(table),
      front_(front),
      progress_(progress),
      gaps_(find_gaps(mesh_, table)),
      plan_{{{GrowthRules::Images::unfolded}, {GrowthRules::Images::rotated}}, kEnlargements, {}} {}

Crossings GrowthTracer::cross_edges(const NearestLabels& labels) const {
  return find_rough_crossings(input(labels), progress_);
}

void GrowthTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                      Crossings& crossings) const {
  gvd::cross_at_most_once(input(labels), edges, crossings);
}

void GrowthTracer::close_faces(TracedDiagram& traced) const {
  refine(traced);
  close_gaps(input(traced.labels), gaps_, plan_, traced, progress_);
}

void GrowthTracer::disable_growth(const std::vector<EdgeId>& edges) { plan_.forbid(edges); }

/// With planar fronts the rough crossings interpolate distances, and unfolding improves them. With circles they come
/// from sources that were unfolded over the edge itself, the same for both of its faces. Refinement would replace these
/// by images that were unfolded over other edges, which is less accurate (docs/developer/performance.md has figures).
void GrowthTracer::refine(TracedDiagram& traced) const {
  if (front_ == Front::circle) return;
  weld_crossings(refine_bisectors(input(traced.labels), traced.crossings, progress_), traced.crossings);
}

}  // namespace gvd
