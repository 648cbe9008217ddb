#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/growing_tracer.hpp"

namespace gvd {

/// The steps of the paper's tracer: rough bisectors, refined and welded (section 4.2), and growth through the gaps
/// (section 4.3).
///
/// Whether the diagram is complete does not depend on the growth: a gap that growth does not close is assembled from
/// its edge crossings. The paper has no such fallback. `trace_connected` runs the steps.
/// Counts gaps; reports the steps "bisectors" and "growth". Cost: O(n).
class GrowthTracer : public GrowingTracer {
 public:
  /// All references must outlive the tracer.
  GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress);

  /// The rough crossings of all edges, between the labels of their ends.
  Crossings cross_edges(const NearestLabels& labels) const override;
  /// Replaces the crossings of these edges, ascending, by at most one, between the labels of the edge's ends.
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  /// Refines the crossings, then fills in the arcs and branch points of all faces, ascending by face: by growth inside
  /// the gaps, by assembly elsewhere. Growth may replace crossings and labels inside its gaps.
  void close_faces(TracedDiagram& traced) const override;

 private:
  void refine(TracedDiagram& traced) const;

  std::vector<Gap> gaps_;
};

}  // namespace gvd
