#pragma once

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/geometry/departure.hpp"
#include "geodesic/windows/geometry/face_frames.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The angles of all corners, and those of the sides round a vertex, as departures count them.
class CornerAngles {
 public:
  CornerAngles() = default;
  /// The mesh has to outlive this. Cost: O(n).
  CornerAngles(const Mesh& mesh, const FaceFrames& frames, const ParallelChunks& parallel);

  bool empty() const { return corner_.empty(); }
  /// The angle of the corner that a halfedge leaves.
  Departure corner(HalfedgeId h) const { return corner_[h]; }
  /// The angle of a halfedge round the vertex that it leaves, counter-clockwise from `mesh.halfedge` of that vertex.
  /// Only generators need it. Cost: O(degree of the vertex).
  Departure side(HalfedgeId h) const;

 private:
  const Mesh* mesh_ = nullptr;
  IdVector<HalfedgeId, Departure> corner_;
};

}  // namespace gvd
