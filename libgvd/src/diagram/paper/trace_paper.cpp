#include "diagram/paper/trace_paper.hpp"

#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/weld_crossings.hpp"
#include "diagram/paper/refine_segments.hpp"
#include "diagram/paper/rough_segments.hpp"

namespace gvd {
namespace {

/// Section 4.3, and the second principle of section 3.
constexpr GrowthRules kPaperRules{GrowthRules::Images::unfolded, EventOrder::by_distance, true};

}  // namespace

PaperTracer::PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress)
    : GrowingTracer(working, table, front, progress, {kPaperRules}), midpoints_(table, mesh().face_count()) {}

Crossings PaperTracer::cross_edges(const NearestLabels& labels) const { return find_rough_segments(mesh(), labels); }

void PaperTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                     Crossings& crossings) const {
  cross_at_midpoints(mesh(), edges, labels, crossings);
}

void PaperTracer::close_faces(TracedDiagram& traced) const {
  weld_crossings(refine_segments(mesh(), midpoints_, traced.crossings), traced.crossings);
  const auto is_branching = [&](FaceId f) { return classify(mesh(), traced.labels.label, f) == FaceClass::branching; };
  close(connect_gaps(mesh(), is_branching), traced);
}

}  // namespace gvd
