#pragma once

#include <array>
#include <vector>

#include "fit_vertices.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The search of flip_edges. All of it must outlive the search.
struct FlipSearch {
  const Mesh* surface = nullptr;
  const ClosestPointTree* tree = nullptr;            ///< of the surface
  const std::vector<Vec3>* at_generators = nullptr;  ///< normals of the surface
  const std::vector<Vec3>* at_faces = nullptr;       ///< normals of the surface at the points of the faces
  const SpringPlan* plan = nullptr;
  const std::vector<char>* on_crease = nullptr;  ///< per vertex: an edge between two of these follows a crease
  double shape = 0;                              ///< the price of 1 - Q for one vertex, as in AnglePrice; > 0
  int threads = 0;
  Progress progress = {};  ///< may be empty
};

/// Chooses edges to flip, at most one for each face.
///
/// An edge is flipped if that lowers the sum of the square distances from the surface and the price of Q of its two
/// triangles. So edges turn along creases, and away from vertices of high valence. Edges that follow creases, edges
/// between held vertices and edges at a vertex of valence three stay. The best flips come first.
///
/// Properties: (1) no new edge joins vertices that have an edge, so the topology stays the same; (2) no new triangle is
/// flipped against the surface or intersects another; (3) an angle below kLeastFlippedAngle is not smaller than the
/// least angle of the two triangles before; (4) deterministic. Cost: O(n log n), and O(1) closest points for each edge
/// that might be better flipped.
std::vector<EdgeFlip> flip_edges(const FlipSearch& search, const Mesh& mesh);

/// New triangles have no angle below this, in degrees, unless the old ones have a smaller one. Users call triangles
/// with angles below 30 degrees thin.
inline constexpr double kLeastFlippedAngle = 30;

}  // namespace gvd
