#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// How a generator may move while it is relaxed.
enum class Freedom {
  free,       ///< over the whole surface
  on_crease,  ///< along the creases, up to their corners
  fixed,      ///< not at all
};

struct CreaseOptions {
  /// Angle between the normals of two faces, degrees, in (0, 180]: a sharper edge is a crease. 180: none is.
  double angle = 180;
  bool with_boundary = false;  ///< edges on the boundary are creases, too
};

/// The creases of a mesh, ascending. A face without area makes no crease.
/// Throws Error{invalid_option} for an angle out of its range. Cost: O(n).
std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options);

/// A crease from corner to corner (see place_on_creases), or a closed one without a corner.
struct CreaseCurve {
  std::vector<EdgeId> edges;  ///< in order
  std::vector<VertexId>
      vertices;         ///< their ends, one more than edges; a closed curve has the first one at its end, too
  bool closed = false;  ///< without a corner; a curve from a corner to itself is not closed
};

/// The curves of the creases, which hold each crease edge once: first those that begin at corners, ascending. Cost:
/// O(n).
/// `corner_distance`: as in place_on_creases.
std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                       double corner_distance = 0);

/// The point of the curve's edge with this index at a distance from `vertices[edge]`, mesh units, which is limited to
/// the edge.
SurfacePoint point_on_curve(const Mesh& mesh, const CreaseCurve& curve, std::size_t edge, double distance);

/// Generators on the creases.
struct FeatureGenerators {
  std::vector<SurfacePoint> points;  ///< corners first
  std::vector<Freedom> freedom;      ///< of the points: fixed at corners, on_crease between them
};

/// The largest angle by which a crease turns at a vertex that is no corner, degrees.
inline constexpr double kCornerTurn = 45;

/// Puts a generator on each corner, and along each crease between two corners as many as keep about this distance.
///
/// A corner is a vertex with one crease edge or more than two, or where a crease turns by more than
/// kCornerTurn, both at the vertex and over five edges on its two sides: small zigzags are none. A
/// closed crease without a corner has at least three generators. Those between corners are evenly spaced by length.
/// Of corners where one crease only turns, the sharpest are kept that are `corner_distance` or more along the crease
/// from other corners: the boundary of a scan may turn at every second vertex.
/// `spacing`: mesh units, > 0. Throws Error{invalid_option} if it is not. Cost: O(n log n).
FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                   double corner_distance = 0);

/// The points, those within `distance` of a crease moved onto it: to its nearest vertex within `distance`, else to the
/// nearest point of its edges. So points that were written with few digits are at corners and on creases again. Only
/// the faces that contain a point are searched, and vertices stay. `distance`: mesh units, >= 0. Cost: O(n).
std::vector<SurfacePoint> snap_to_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                          std::vector<SurfacePoint> points, double distance);

/// What each of these points may do by where it lies: fixed at a corner of a crease, on_crease beside it on the crease,
/// free elsewhere. Cost: O(n).
std::vector<Freedom> freedoms_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                         const std::vector<SurfacePoint>& points);

}  // namespace gvd
