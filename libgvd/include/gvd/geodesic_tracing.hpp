#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Tangent vectors at a surface point are plane vectors in mesh units. Their x axis is, seen from outside the surface,
//   in a face: the direction of its halfedge 0;
//   on an edge: the direction of `halfedge(point)`, so y > 0 leads into `point.face` and y < 0 into the face beyond;
//   at a vertex v: the direction of `mesh.halfedge(v)`.
// Angles count counter-clockwise. Round an interior vertex they are scaled so that the total angle becomes 2 pi; at a
// boundary vertex they stay as they are (unless they exceed 2 pi), so directions beyond the total angle lead off the
// surface.

namespace gvd {

/// A straight line on the surface.
struct GeodesicTrace {
  std::vector<SurfacePoint>
      points;                     ///< from start to end; consecutive points share a face; one where nothing was traced
  Vec2 direction = Vec2::Zero();  ///< unit: where it goes on, as a tangent vector at its end; zero for a zero tangent
  double length = 0;              ///< mesh units
  bool complete = true;           ///< false where it ended at the boundary before its length was traced
};

/// Walks a straight line from `start` along `tangent`, as far as the tangent is long (the exponential map).
///
/// Faces are unfolded across their edges. Through a vertex the line goes on with equal angles on both sides (the
/// straightest geodesic of Polthier and Schmies, 1998). At the boundary it ends; it does not slide along it.
/// Properties: (1) every point lies on the surface; (2) `length` <= |tangent| within rounding, and equal where
/// `complete`; (3) from the end, with the direction reversed, it leads back to the start within rounding, where it
/// meets no vertex within rounding. Throws Error{precondition} where the start's face does not exist or the tangent is
/// not finite. Cost: O(faces crossed), and the degree of each vertex met.
GeodesicTrace trace_geodesic(const Mesh& mesh, const SurfacePoint& start, const Vec2& tangent);

/// The tangent vector at `point` that is nearest to `tangent` among those that lead into the surface: `tangent` itself
/// but on the boundary, where an outward one slides along the boundary or becomes zero.
Vec2 project_to_surface(const Mesh& mesh, const SurfacePoint& point, const Vec2& tangent);

}  // namespace gvd
