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

/// The arcs and branch points of a number of faces.
struct AssembledFaces {
  FaceDiagram diagram;
  std::vector<StraightenedFace> straightened;  ///< ascending
};

/// Traces the diagram of a distance field, as exactly as the field is. Crossings are the corners of the lower envelope
/// of the distances on each edge, stored once for both faces. Every face is assembled from its crossings, and its arcs
/// are refined until they are within a tolerance of the bisectors.
///
/// Several threads cross edges and close faces; the distance field must allow that. Reports the steps "bisectors" and
/// "faces"; counts straightened faces. Cost: O(n + k) for k points of the bisectors.
class EnvelopeTracer final : public DiagramTracer {
 public:
  /// `tolerance`: mesh units. All arguments must outlive the tracer.
  EnvelopeTracer(const WorkingMesh& working, const DistanceField& field, double tolerance,
                 const ParallelChunks& parallel);

  Crossings cross_edges(const NearestLabels& labels) const override;
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  void close_faces(TracedDiagram& traced) override;

  /// The crossings of some edges, which ascend, as `cross_edges` finds them; or at most one of each.
  std::vector<Crossing> cross(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                              bool at_most_once = false) const;
  /// Assembles some faces, which ascend, by several threads. `counts`: of the crossings on each face.
  AssembledFaces assemble(const std::vector<FaceId>& faces, const IdVector<FaceId, std::int32_t>& counts,
                          const Crossings& crossings) const;

 private:
  const Mesh& mesh_;
  const DistanceField& field_;
  const ParallelChunks& parallel_;
  double tolerance_;
  SymbolicOffset offset_;
};

/// All that the faces of an envelope are assembled from.
struct EnvelopeFaces {
  const Mesh& mesh;
  const Crossings& crossings;
  const DistanceField& field;
  SymbolicOffset offset;  ///< of the crossings
  double tolerance;       ///< mesh units, > 0
};

/// Assembles some faces, which ascend: joins their crossings by the distances in them, refines the arcs to within the
/// tolerance of the bisectors, and measures the branch points. Arcs never intersect.
/// Cost: O(points of the bisectors), and that of the assembly in faces with many crossings.
AssembledFaces assemble_envelope(const EnvelopeFaces& input, std::span<const FaceId> faces);

}  // namespace gvd
