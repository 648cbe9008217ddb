#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

struct CreaseOptions {
  /// An edge is a crease if the normals of its two faces form a larger angle than this. Degrees, in (0, 180]; with 180,
  /// no edge is a crease.
  double angle = 180;
  bool with_boundary = false;  ///< whether boundary edges are creases, too
};

/// Finds the creases of a mesh, each by its own two faces. For creases that generators are to follow, see
/// find_crease_chains.
///
/// Properties: (1) the ids ascend, each once; (2) an edge between two faces is a crease if their normals form a larger
/// angle than `options.angle`; (3) an edge of a face without area is no crease, unless it is on the boundary.
/// Throws Error{invalid_option} for an angle out of its range. Cost: O(n).
std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options);

/// Creases as the surface looks at a scale, ascending.
struct CreaseChains {
  std::vector<EdgeId> edges;
  /// How much of the turn at each edge lies within an eighth of the spacing, from 0 to 1: 1 at a sharp edge, less at a
  /// rounded one.
  std::vector<double> crispness;
};

/// Finds the creases of a surface as it looks at the scale of a sampling: chains and loops of edges, one for each
/// crease.
///
/// The angle at an edge is that between the mean normals of the surface on its two sides, within half a spacing. So
/// slivers and folds of slivers do not count, a fillet narrower than half a spacing is one crease along its middle, and
/// a surface that is curved as a whole has none.
///
/// Properties: (1) each chain has an edge with an angle of at least `angle`, and all its edges have at least half of it,
/// except in gaps below three quarters of a spacing; (2) a crease within three quarters of a spacing beside another one
/// has 1.25 times `angle` where it begins, and `angle` where it goes on; otherwise it is a shoulder of the other one;
/// (3) groups of chains shorter than a spacing are left out, and branches that end inside the surface after less.
///
/// `angle`: degrees, in (0, 180]; with 180, there is no crease. `spacing`: mesh units, > 0. Meshes of many more faces
/// than samples are seen at the scale of a hundred faces. Throws Error{invalid_option} for a number out of its range.
/// Cost: O(n log n), with a disc of at most 400 faces for each edge that a smaller one shows to be sharp.
CreaseChains find_crease_chains(const Mesh& mesh, double angle, double spacing);

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
