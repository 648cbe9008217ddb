#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Tangent vectors at a surface point are plane vectors in mesh units. Their x axis is, seen from outside the surface,
//   in a face: the direction of its halfedge 0;
//   on an edge: the direction of `halfedge(point)`, so y > 0 leads into `point.face`, y < 0 into the adjacent face;
//   at a vertex v: the direction of `mesh.halfedge(v)`.
// Angles are counter-clockwise. Round an interior vertex they are scaled so that the total angle becomes 2 pi. At a
// boundary vertex they are scaled only if the total angle exceeds 2 pi; directions beyond it lead off the surface.

namespace gvd {

/// A straight line on the surface.
struct GeodesicTrace {
  /// From start to end; consecutive points share a face. For a zero tangent there is only the start.
  std::vector<SurfacePoint> points;
  Vec2 direction = Vec2::Zero();  ///< unit tangent vector of the line at its end; zero for a zero tangent
  double length = 0;              ///< mesh units
  bool complete = true;           ///< false if it ended at the boundary before its full length
};

/// The exponential map: traces a straight line from `start` in the direction of `tangent`, with its length.
///
/// Faces are unfolded across their edges. Through a vertex the line continues with equal angles on both sides (the
/// straightest geodesic of Polthier and Schmies, 1998). It ends at the boundary.
/// Properties: (1) every point lies on the surface; (2) `length` <= |tangent| within rounding, and equal if `complete`;
/// (3) traced back from its end, the line returns to the start within rounding if it passes no vertex.
/// Throws Error{precondition} if the start's face does not exist or the tangent is not finite.
/// Cost: O(faces crossed), and the degree of each vertex passed.
GeodesicTrace trace_geodesic(const Mesh& mesh, const SurfacePoint& start, const Vec2& tangent);

/// The tangent vector nearest to `tangent` among those at `point` that lead into the surface. That is `tangent` itself,
/// except for an outward one at the boundary, which is projected to the boundary or becomes zero.
Vec2 project_to_surface(const Mesh& mesh, const SurfacePoint& point, const Vec2& tangent);

}  // namespace gvd
