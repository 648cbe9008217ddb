#pragma once

#include <array>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A point of the surface: a face and barycentric coordinates in it.
///
/// Properties: (1) every coordinate is in [0, 1] and they sum to 1 within rounding; (2) the point lies on
/// an edge or a vertex exactly when one or two coordinates are exactly 0, so its kind is a fact, not a
/// tolerance. `make_surface_point` establishes both for arbitrary coordinates.
struct SurfacePoint {
  enum class Kind { vertex, edge, face };

  FaceId face;
  std::array<double, 3> bary{1, 0, 0};

  Kind kind() const;
  bool operator==(const SurfacePoint&) const = default;
};

/// A barycentric coordinate at or below this becomes 0. Dimensionless: a fraction of the triangle's height. It is ten
/// thousand units in the last place of 1: far above the rounding of the coordinates, far below any length that matters.
inline constexpr double kBarycentricSnap = 1e-12;

/// The point of face f with these coordinates, scaled to sum 1; those at or below kBarycentricSnap become exactly 0.
/// Throws Error{precondition} where a coordinate is not finite or below -1e-9, or where their sum is not within 1e-6 of
/// 1.
SurfacePoint make_surface_point(FaceId face, const std::array<double, 3>& bary);

/// The vertex v, in the face of `mesh.halfedge(v)`.
SurfacePoint vertex_point(const Mesh& mesh, VertexId v);

/// The point (1 - t) from(h) + t to(h), in h's face. t in [0, 1].
SurfacePoint edge_point(HalfedgeId h, double t);

/// Surface points closer than this fraction of the bounding box's diagonal coincide. Dimensionless. The rounding error
/// of a position is about 1e-15 of the box, and this is a thousand times as much. Far from the origin the rounding
/// error is larger: see `coincidence`.
inline constexpr double kCoincidence = 1e-12;

/// Position in mesh units.
Vec3 position(const Mesh& mesh, const SurfacePoint& point);

/// The value at a point that is linear between the values of its face's vertices. A vertex with weight 0 is left out,
/// as its value may be infinite.
double interpolate_at(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point);

/// The vertex that a point of kind vertex lies on.
VertexId vertex(const Mesh& mesh, const SurfacePoint& point);

/// For a point of kind edge: the halfedge of `point.face` that it lies on.
HalfedgeId halfedge(const SurfacePoint& point);

/// Whether the point lies on the mesh's boundary.
bool is_on_boundary(const Mesh& mesh, const SurfacePoint& point);

/// The faces that contain the point: one inside a face, two on an inner edge, all faces of a vertex. Cost: O(their
/// number).
std::vector<FaceId> faces_around(const Mesh& mesh, const SurfacePoint& point);

/// The same point seen from the face with the smallest id that contains it: equal surface points compare equal.
SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point);

}  // namespace gvd
