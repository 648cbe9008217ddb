#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/envelope/arc_intersections.hpp"
#include "diagram/envelope/refine_arcs.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "diagram/graph/face_pieces.hpp"
#include "geodesic/field/distance_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Faces whose crossings are joined.
struct AssembledFaces {
  FaceDiagram diagram;
  std::int64_t straightened = 0;  ///< faces with an arc that would have met itself or another one
};

/// Closes faces one after the other: assembles each from its crossings and the distances in it, bends the arcs to
/// within `tolerance` (mesh units) of the bisectors and measures the branch points. What it reads has to outlive it.
///
/// Arcs are bent only as far as they keep apart: one that meets itself loses its loops; of arcs that meet each other
/// when they are bent, some stay straight; and where straight ones cross too, because the distances contradict each
/// other, the face is assembled by convex steps alone.
/// Cost: O(points of the bisectors), and what the assembly takes where a face has many crossings.
class ExactFaceAssembler {
 public:
  ExactFaceAssembler(const ExactFaceAssembler&) = delete;
  ExactFaceAssembler& operator=(const ExactFaceAssembler&) = delete;
  /// `tie_step`: the symbolic offset between two generators that follow each other, mesh units, as on the edges.
  ExactFaceAssembler(const Mesh& mesh, const Crossings& crossings, const DistanceField& field, double tie_step,
                     double tolerance)
      : mesh_(mesh), crossings_(crossings), distances_(field, tie_step), refiner_(distances_, tolerance) {}

  /// Appends face f to the result; faces come in ascending order.
  void close(FaceId f);

  AssembledFaces take_result() { return std::move(closed_); }

 private:
  /// What the result held before the face at work.
  struct Before {
    std::size_t arcs, branches, points;
  };

  void assemble(FaceId f);
  void refine(FaceArc& arc);
  void keep_apart(FaceArc& arc);
  FaceDistances::Bary place(const ArcEnd& end) const;
  bool may_meet(const Before& before) const;
  bool advances(const FaceArc& arc) const;
  void outline(const Before& before);
  FaceArc* most_met(const Before& before);
  bool are_turned(const Before& before);
  void measure_branches(const Before& before);

  const Mesh& mesh_;
  const Crossings& crossings_;
  SourceDistances distances_;  // of the face at work
  ArcRefiner refiner_;
  std::vector<BoundaryCrossing> boundary_;
  std::vector<ArcSegment> segments_;
  ArcIntersections meetings_;
  WorkingPieces pieces_;
  AssembledFaces closed_;
};

}  // namespace gvd
