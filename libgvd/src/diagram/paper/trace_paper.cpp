#include "diagram/paper/trace_paper.hpp"

#include "diagram/graph/face_class.hpp"
#include "diagram/growth/close_gaps.hpp"
#include "diagram/growth/weld_crossings.hpp"
#include "diagram/paper/refine_segments.hpp"
#include "diagram/paper/rough_segments.hpp"

namespace gvd {
namespace {

/// Section 4.3, and the second principle of section 3.
constexpr GrowthRules kPaperRules{GrowthRules::Images::unfolded, EventOrder::by_distance, true};

/// How often branching faces that do not close are enlarged: ends grow from triangle to triangle, and the paper names
/// no limit. It is the same as for GrowthTracer.
constexpr int kEnlargements = 10;

}  // namespace

PaperTracer::PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress)
    : working_(working),
      table_(table),
      front_(front),
      progress_(progress),
      midpoints_(table, working.mesh().face_count()),
      plan_{{kPaperRules}, kEnlargements, {}} {}

Crossings PaperTracer::cross_edges(const NearestLabels& labels) const {
  return find_rough_segments(working_.mesh(), labels);
}

void PaperTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                     Crossings& crossings) const {
  cross_at_midpoints(working_.mesh(), edges, labels, crossings);
}

void PaperTracer::close_faces(TracedDiagram& traced) const {
  const Mesh& mesh = working_.mesh();
  weld_crossings(refine_segments(mesh, midpoints_, traced.crossings), traced.crossings);
  const auto is_branching = [&](FaceId f) { return classify(mesh, traced.labels.label, f) == FaceClass::branching; };
  close_gaps(input(traced.labels), connect_gaps(mesh, is_branching), plan_, traced, progress_);
}

void PaperTracer::disable_growth(const std::vector<EdgeId>& edges) { plan_.forbid(edges); }

}  // namespace gvd
