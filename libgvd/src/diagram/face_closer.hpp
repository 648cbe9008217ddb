#pragma once

#include <cstdint>
#include <vector>

#include "diagram/crossings.hpp"
#include "diagram/face_diagram.hpp"
#include "diagram/face_pieces.hpp"
#include "diagram/source_metric.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Faces whose crossings are joined.
struct ClosedFaces {
  FaceDiagram diagram;
  std::int64_t straightened = 0;  ///< faces whose bent arcs would have crossed
};

/// Closes faces one after the other: assembles each from its crossings and the distances in it, bends the arcs to
/// within `tolerance` (mesh units) of the bisectors and measures the branch points. What it reads has to outlive it.
/// Cost: O(points of the bisectors), and what the assembly takes where a face has many crossings.
class FaceCloser {
 public:
  FaceCloser(const Mesh& mesh, const Crossings& crossings, const SourceMetric& metric, double tolerance)
      : mesh_(mesh), crossings_(crossings), metric_(metric), tolerance_(tolerance) {}

  /// Appends face f to the result; faces come in ascending order.
  void close(FaceId f);

  ClosedFaces take_result() { return std::move(closed_); }

 private:
  void bend(FaceArc& arc);
  FaceMetric::Bary place(const ArcEnd& end) const;
  bool arcs_cross(std::size_t first_arc);
  void measure_branches(std::size_t first_arc, std::size_t first_branch);

  const Mesh& mesh_;
  const Crossings& crossings_;
  SourceMetric metric_;  // of the face at work
  double tolerance_;
  std::vector<BoundaryCrossing> boundary_;
  WorkingPieces pieces_;
  ClosedFaces closed_;
};

}  // namespace gvd
