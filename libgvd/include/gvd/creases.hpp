#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// How the faces of an edge are compared with the angle of a crease. The two rules can differ at that angle itself, by
/// rounding, and at faces whose areas underflow.
enum class CreaseRule {
  cosine,  ///< by the cosine, with normals that are scaled before they are normalized
  angle,   ///< by the angle, with the normals of `face_normal`
};

struct CreaseOptions {
  /// Angle between the normals of two faces, degrees, in (0, 180]: a sharper edge is a crease. 180: none is.
  double angle = 180;
  bool with_boundary = false;  ///< edges on the boundary are creases, too
  CreaseRule rule = CreaseRule::cosine;
};

/// The creases of a mesh, ascending. A face without area makes no crease.
/// Throws Error{invalid_option} for an angle out of its range. Cost: O(n).
std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options);

/// The largest angle by which a crease turns at a vertex that is no corner, degrees.
inline constexpr double kCornerTurn = 45;

/// A crease from corner to corner, or a closed one without a corner.
struct CreaseCurve {
  std::vector<EdgeId> edges;       ///< in order
  std::vector<VertexId> vertices;  ///< their ends, one more than edges; the first one is also the last if `closed`
  bool closed = false;             ///< without a corner; a curve from a corner to itself is not closed
};

/// The curves of the creases, which hold each crease once: first those that begin at corners, by their first vertices,
/// then the closed ones.
///
/// A corner is a vertex with one crease or more than two, or where a crease turns by more than kCornerTurn, both at the
/// vertex and over five edges on its two sides: small zigzags are none. Of corners where one crease only turns, the
/// sharpest are kept that are `corner_distance` (mesh units) or more along the crease from other corners: the boundary
/// of a scan may turn at every second vertex. Cost: O(n log n).
std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                       double corner_distance = 0);

}  // namespace gvd
