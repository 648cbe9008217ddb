#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// How the angle between the two faces of an edge is compared with the angle of a crease. The two rules can differ if
/// the angles are equal within rounding, and at faces whose areas underflow.
enum class CreaseRule {
  cosine,  ///< by the cosine, with normals that are scaled before they are normalized
  angle,   ///< by the angle, with the normals of `face_normal`
};

struct CreaseOptions {
  /// An edge is a crease if the normals of its two faces form a larger angle than this. Degrees, in (0, 180]; with 180,
  /// no edge is a crease.
  double angle = 180;
  bool with_boundary = false;  ///< whether boundary edges are creases, too
  CreaseRule rule = CreaseRule::cosine;
};

/// Finds the creases of a mesh.
///
/// Properties: (1) the ids ascend, each once; (2) an edge between two faces is a crease if their normals form a larger
/// angle than `options.angle`, as `options.rule` compares them; (3) an edge of a face without area is no crease, unless
/// it is on the boundary.
/// Throws Error{invalid_option} for an angle out of its range. Cost: O(n).
std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options);

/// The turn of a crease, in degrees, above which there can be a corner.
inline constexpr double kCornerTurn = 45;

/// A chain of creases from corner to corner, or a closed chain without a corner.
struct CreaseCurve {
  std::vector<EdgeId> edges;       ///< in order
  std::vector<VertexId> vertices;  ///< their ends, one more than edges; the first one is also the last if `closed`
  bool closed = false;             ///< without a corner; a curve from a corner to itself is not closed
};

/// Joins creases to curves. A corner is a vertex where one crease or more than two meet, or where a crease turns by
/// more than kCornerTurn, both at the vertex itself and between the chords over five edges on its two sides, so that
/// small zigzags make no corner.
///
/// If `corner_distance` (mesh units) is above 0, corners where a crease only turns are thinned out, because the
/// boundary of a scan may turn at every second vertex: beginning with the sharpest, each is kept if no corner that has
/// been kept is nearer than that along the crease.
/// Properties: (1) each crease is in exactly one curve; (2) curves that begin at corners come first, in the order of
/// their first vertices, then closed curves. Cost: O(n log n).
std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                       double corner_distance = 0);

}  // namespace gvd
