#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The arcs and branch points of some faces.
struct AssembledFaces {
  FaceDiagram diagram;
  std::vector<StraightenedFace> straightened;  ///< ascending
};

/// Traces the diagram of a distance field. The diagram is as exact as the field. Crossings are the corners of the lower
/// envelope of the distances on each edge, stored once for both faces. Every face is assembled from its crossings, and
/// its arcs are refined until they are within a tolerance of the bisectors.
///
/// Several threads cross edges and close faces; the distance field must allow that. Reports the steps "bisectors" and
/// "faces"; counts straightened faces. Cost: O(n + k) for k points of the bisectors.
class EnvelopeTracer final : public DiagramTracer {
 public:
  /// `tolerance` is in mesh units. All arguments must outlive the tracer.
  EnvelopeTracer(const WorkingMesh& working, const DistanceField& field, double tolerance,
                 const ParallelChunks& parallel);

  Crossings cross_edges(const NearestLabels& labels) const override;
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  void close_faces(TracedDiagram& traced) override;

  /// The crossings of some edges as `cross_edges` finds them, or at most one crossing per edge. The edges must ascend.
  std::vector<Crossing> cross(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                              bool at_most_once = false) const;
  /// Assembles some faces, which must ascend. Several threads take part. `counts` has the number of crossings on each
  /// face.
  AssembledFaces assemble(const std::vector<FaceId>& faces, const IdVector<FaceId, std::int32_t>& counts,
                          const Crossings& crossings) const;

 private:
  const Mesh& mesh_;
  const DistanceField& field_;
  const ParallelChunks& parallel_;
  double tolerance_;
  SymbolicOffset offset_;
};

/// The input for assembling faces by envelopes.
struct EnvelopeFaces {
  const Mesh& mesh;
  const Crossings& crossings;
  const DistanceField& field;
  SymbolicOffset offset;  ///< symbolic offset of the crossings
  double tolerance;       ///< mesh units, > 0
};

/// Assembles some faces, which must ascend: joins their crossings as the distances in them require, refines the arcs
/// until they are within the tolerance of the bisectors, and measures the branch points. Arcs never intersect.
/// Cost: O(points of the bisectors), and the cost of `assemble_face` in faces with many crossings.
AssembledFaces assemble_envelope(const EnvelopeFaces& input, std::span<const FaceId> faces);

}  // namespace gvd
