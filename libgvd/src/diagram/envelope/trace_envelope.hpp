#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The steps that trace the diagram of a distance field, as exactly as the field is. Crossings are the corners of the
/// lower envelope of the distances on each edge, stored once for both faces. Every face is assembled from its
/// crossings, and its arcs are refined until they are within a tolerance of the bisectors.
///
/// Several threads cross edges and close faces; the distance field must allow that. `trace_connected` runs the steps.
/// Reports the steps "bisectors" and "faces". Cost: O(n + k) for k points of the bisectors.
class EnvelopeTracer {
 public:
  /// `tolerance`: mesh units. All arguments must outlive the tracer.
  EnvelopeTracer(const WorkingMesh& working, const DistanceField& field, double tolerance,
                 const ParallelChunks& parallel);

  /// The crossings of all edges, between the labels of their ends.
  Crossings cross_edges(const NearestLabels& labels) const;
  /// Replaces the crossings of these edges, ascending, by at most one, between the labels of the edge's ends.
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels, Crossings& crossings) const;
  /// Fills in the arcs and branch points of all faces, ascending by face; counts straightened faces.
  void close_faces(TracedDiagram& traced) const;

 private:
  enum class Limit { none, one_crossing };
  std::vector<Crossing> cross(const std::vector<EdgeId>& edges, const NearestLabels& labels, Limit limit) const;

  const Mesh& mesh_;
  const DistanceField& field_;
  const ParallelChunks& parallel_;
  double tolerance_;
  SymbolicOffset offset_;
};

}  // namespace gvd
