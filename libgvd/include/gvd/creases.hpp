#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

struct CreaseOptions {
  /// Angle between the normals of two faces, degrees, in (0, 180]: a sharper edge is a crease. 180: none is.
  double angle = 180;
  bool with_boundary = false;  ///< edges on the boundary are creases, too
};

/// The creases of a mesh, ascending, each by its own two faces. A face without area makes no crease. For creases that
/// generators are to follow, see find_crease_chains.
/// Throws Error{invalid_option} for an angle out of its range. Cost: O(n).
std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options);

/// Creases as the surface looks at a scale, ascending.
struct CreaseChains {
  std::vector<EdgeId> edges;
  /// How much of the turn at each edge lies within an eighth of the spacing, from 0 to 1: 1 at a sharp edge, less at a
  /// rounded one.
  std::vector<double> crispness;
};

/// The creases of a surface as it looks at the scale of a sampling: chains and loops of edges, one for each crease.
///
/// The angle at an edge is that between the mean normals of the surface on its two sides, within half a spacing. So
/// slivers and folds of slivers have no voice, a fillet narrower than half a spacing is one crease along its middle,
/// and a surface that is curved as a whole has none.
///
/// Properties: (1) each chain has an edge with an angle of at least `angle`, and all its edges have at least half of it,
/// but for gaps below three quarters of a spacing; (2) a crease within three quarters of a spacing beside another one
/// has 1.25 times `angle` where it begins, and `angle` where it goes on, else it is a shoulder of the other one;
/// (3) groups of chains shorter than a spacing are left out, and branches that end inside the surface after less.
///
/// `angle`: degrees, in (0, 180]; 180: no crease. `spacing`: mesh units, > 0. Meshes of many more faces than samples
/// are seen at the scale of a hundred faces. Throws Error{invalid_option} for a number out of its range.
/// Cost: O(n log n), with a disc of at most 400 faces for each edge that a smaller one shows to be sharp.
CreaseChains find_crease_chains(const Mesh& mesh, double angle, double spacing);

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
