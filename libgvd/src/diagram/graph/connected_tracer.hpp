#pragma once

#include <cstdint>
#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The steps that differ between tracers; `trace_connected` runs them. Lists of edges are ascending.
class DiagramTracer {
 public:
  virtual ~DiagramTracer() = default;

  /// The crossings of all edges, between the labels of their ends.
  virtual Crossings cross_edges(const NearestLabels& labels) const = 0;
  /// Replaces the crossings of these edges by at most one, between the labels of the edge's ends.
  virtual void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                  Crossings& crossings) const = 0;
  /// Fills in the arcs and branch points of all faces, ascending by face. It may change the diagram's crossings and
  /// labels.
  virtual void close_faces(TracedDiagram& traced) = 0;
  /// From now on, the tracer closes the faces at these edges by their crossings alone. A tracer without growth ignores
  /// it.
  virtual void disable_growth(const std::vector<EdgeId>&) {}
};

/// Traces a diagram whose cells are connected, whatever the distances are.
///
/// Counts relabelled vertices; reports the step "bisectors" and those of the tracer. Cost: O(n) a round; most diagrams
/// need one.
TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer,
                              const Progress& progress);

/// Finds the edges, ascending, with an inner label interval that no chain of intervals through common faces connects to
/// a corner of its cell. Such intervals occur because an edge knows only the tables of its two faces. Cost: O(c log c)
/// for c crossings.
std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings);

}  // namespace gvd
