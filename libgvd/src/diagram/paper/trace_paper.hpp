#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/growing_tracer.hpp"
#include "diagram/paper/midpoint_distances.hpp"

namespace gvd {

/// The steps of sections 4.2 and 4.3 as the paper has them: rough segments between edge midpoints, refined by unfolding
/// from the midpoints' distances, and growth through the branching faces.
///
/// A set of branching faces that growth does not close is assembled from its edge crossings, because the paper does not
/// say how to go on. `trace_connected` runs the steps. Counts gaps; reports the steps "bisectors" and "growth".
/// Cost: O(n).
class PaperTracer : public GrowingTracer {
 public:
  /// All references must outlive the tracer.
  PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress);

  /// The midpoints of all edges between two labels.
  Crossings cross_edges(const NearestLabels& labels) const override;
  /// Puts these edges, ascending, back to at most one crossing.
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  /// Refines the crossings, then fills in the arcs and branch points of all faces, ascending by face.
  void close_faces(TracedDiagram& traced) const override;

 private:
  MidpointDistances midpoints_;
};

}  // namespace gvd
