#pragma once

#include <vector>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/propagation/pseudo_sources.hpp"
#include "gvd/mesh.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Finds the sectors through which the vertices of curves send windows. This is done once per vertex at the start, so
/// that computing angles by arc tangents costs next to nothing.
class CurveSectors {
 public:
  /// `mesh` and `frames` must outlive this object. Cost: O(n).
  CurveSectors(const Mesh& mesh, const FaceFrames& frames, const CurveEdges& curves);

  /// The sectors at a vertex, counter-clockwise. Cost: O(valence).
  std::vector<CurveSector> at(VertexId v) const;

 private:
  /// The edges at a vertex by their angles, counter-clockwise, radians.
  struct Spokes {
    std::vector<HalfedgeId> corner;   ///< the halfedges that leave the vertex, one for each face
    std::vector<double> angle;        ///< angles of these halfedges, and at the end the total angle
    std::vector<double> curve_angle;  ///< angles of the edges that belong to the curve
  };
  Spokes spokes(VertexId v) const;
  static FanRay ray(const Spokes& spokes, double angle);

  const Mesh& mesh_;
  const FaceFrames& frames_;
  std::vector<bool> is_curve_;  // [edge]
};

}  // namespace gvd
