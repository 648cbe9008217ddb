#pragma once

#include <array>
#include <optional>
#include <utility>
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
/// thousand units in the last place of 1, which is far above the rounding of the coordinates and far below any length
/// that matters.
inline constexpr double kBarycentricSnap = 1e-12;

/// The point of face f with these coordinates, scaled to sum 1; those at or below kBarycentricSnap become exactly 0.
/// Throws Error{precondition} if a coordinate is not finite or below -1e-9, or if their sum is not within 1e-6 of 1.
SurfacePoint make_surface_point(FaceId face, const std::array<double, 3>& bary);

/// Like make_surface_point, but coordinates that are already those of a surface point are kept bit by bit.
/// make_surface_point would change their last bits.
SurfacePoint restore_surface_point(FaceId face, const std::array<double, 3>& bary);

/// The vertex v, in the face of `mesh.halfedge(v)`.
SurfacePoint vertex_point(const Mesh& mesh, VertexId v);

/// The point (1 - t) from(h) + t to(h), in h's face. t must be in [0, 1].
SurfacePoint edge_point(HalfedgeId h, double t);

/// Surface points closer than this fraction of the bounding box's diagonal coincide. Dimensionless. This is a thousand
/// times the rounding error of a position, which is about 1e-15 of the box. Far from the origin the rounding error is
/// larger: see `coincidence`.
inline constexpr double kCoincidence = 1e-12;

/// Positions closer than this fraction of the largest coordinate can't be told apart. Dimensionless. A position is
/// rounded by up to 2^-53 of its largest coordinate, and the distance of two positions by up to nine times as much.
inline constexpr double kCoordinateRounding = 1e-15;

/// Generators closer than this coincide, in mesh units: a fraction of the bounding box's diagonal, or, far from the
/// origin, the rounding error of positions.
double coincidence(const Mesh& mesh);

/// Position in mesh units.
Vec3 position(const Mesh& mesh, const SurfacePoint& point);

/// Interpolates linearly between the values at the vertices of a point's face. A vertex with weight 0 is left out,
/// because its value may be infinite.
double interpolate_at(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point);

/// The vertex on which a point of kind vertex lies.
VertexId vertex(const Mesh& mesh, const SurfacePoint& point);

/// The halfedge of `point.face` on which a point of kind edge lies.
HalfedgeId halfedge(const SurfacePoint& point);

/// Whether the point lies on the mesh's boundary.
bool is_on_boundary(const Mesh& mesh, const SurfacePoint& point);

/// The faces that contain the point: one for a point inside a face, two for a point on an inner edge, and all faces of
/// a vertex. Cost: O(their number).
std::vector<FaceId> faces_around(const Mesh& mesh, const SurfacePoint& point);

/// The point seen from the face with the smallest id that contains it: canonical forms of one point compare equal.
SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point);

/// A point on an edge as seen from the face on the other side; nothing on the boundary. The weights of the two corners
/// are the same numbers.
std::optional<SurfacePoint> find_view_across(const Mesh& mesh, const SurfacePoint& point);

/// The point seen from every face that contains it: one view inside a face, at most two on an edge, the whole fan at a
/// vertex. Ascending by face. Cost: O(valence).
std::vector<SurfacePoint> find_views(const Mesh& mesh, const SurfacePoint& point);

/// Two points as seen from a face that contains both; if there are several, from the one with the least id. Nothing if
/// there is none.
std::optional<std::pair<SurfacePoint, SurfacePoint>> find_common_view(const Mesh& mesh, const SurfacePoint& a,
                                                                      const SurfacePoint& b);

/// Unit normal of a face; zero for one without area. Cost: O(1).
Vec3 face_normal(const Mesh& mesh, FaceId f);

/// Angle of the corner where a halfedge begins, in radians, from 0 to pi. Cost: O(1).
double corner_angle(const Mesh& mesh, HalfedgeId h);

/// Unit normal of the surface at a point: inside a face its normal, on an edge the mean of its two faces, at a vertex
/// the mean of its faces weighted by their angles. Zero if none of these faces has an area. Cost: O(valence).
Vec3 surface_normal(const Mesh& mesh, const SurfacePoint& point);

}  // namespace gvd
