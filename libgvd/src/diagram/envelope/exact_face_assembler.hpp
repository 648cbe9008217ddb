#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/envelope/open_face.hpp"
#include "diagram/envelope/refine_arcs.hpp"
#include "diagram/envelope/separate_arcs.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The arcs and branch points of a number of faces.
struct AssembledFaces {
  FaceDiagram diagram;
  std::int64_t straightened = 0;  ///< faces with an arc that lost points because it intersected itself or another one
  double straightened_error = 0;  ///< largest difference of the two distances along an arc of these faces, mesh units
};

/// Assembles faces one after the other: joins their crossings by the distances in them, refines the arcs to within a
/// tolerance of the bisectors, and measures the branch points.
///
/// Arcs never intersect. A refined arc that intersects itself loses its loops; of refined arcs that intersect each
/// other, some stay straight. Where even straight arcs intersect, because rounded distances contradict each other, the
/// face is assembled again by convex steps alone.
/// Cost: O(points of the bisectors), and that of the assembly in faces with many crossings.
class ExactFaceAssembler {
 public:
  ExactFaceAssembler(const ExactFaceAssembler&) = delete;
  ExactFaceAssembler& operator=(const ExactFaceAssembler&) = delete;
  /// All that it reads must outlive it. `offset`: the symbolic offset of the crossings; `tolerance`: mesh units, > 0.
  ExactFaceAssembler(const Mesh& mesh, const Crossings& crossings, const DistanceField& field,
                     const SymbolicOffset& offset, double tolerance)
      : mesh_(mesh), crossings_(crossings), distances_(field, offset), refiner_(distances_, tolerance) {}

  /// Appends face f to the result. Faces come in ascending order.
  void assemble(FaceId f);

  AssembledFaces take_result() { return std::move(result_); }

 private:
  void join_crossings(FaceId f);
  void refine(const OpenFace& face, FaceArc& arc);
  void measure_branches(const OpenFace& face);
  double largest_error(const OpenFace& face) const;

  const Mesh& mesh_;
  const Crossings& crossings_;
  SourceDistances distances_;  // in the current face
  ArcRefiner refiner_;
  ArcSeparator separator_;
  std::vector<BoundaryCrossing> boundary_;
  AssembledFaces result_;
};

}  // namespace gvd
