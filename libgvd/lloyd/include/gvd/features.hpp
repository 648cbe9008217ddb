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

/// A crease from corner to corner, or a closed one without a corner.
///
/// A corner is a vertex with one crease edge or more than two, or where a crease turns by more than 45 degrees, both at
/// the vertex and over five edges on its two sides: small zigzags are none.
struct CreaseCurve {
  std::vector<EdgeId> edges;  ///< in order
  std::vector<VertexId>
      vertices;         ///< their ends, one more than edges; a closed curve has the first one at its end, too
  bool closed = false;  ///< without a corner; a curve from a corner to itself is not closed
};

/// The curves of the creases, which hold each crease edge once: first those that begin at corners, ascending.
/// Where one crease only turns, the sharpest corners count that are `corner_distance` or more along the crease from
/// other corners: the boundary of a scan may turn at every second vertex. Cost: O(n log n).
std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                       double corner_distance = 0);

/// The point of the curve's edge with this index at a distance from `vertices[edge]`, mesh units, which is limited to
/// the edge.
SurfacePoint point_on_curve(const Mesh& mesh, const CreaseCurve& curve, std::size_t edge, double distance);

}  // namespace gvd
