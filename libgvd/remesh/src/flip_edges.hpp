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
  const std::vector<Vec3>* at_faces = nullptr;       ///< those at the points of the faces
  const SpringPlan* plan = nullptr;
  const std::vector<char>* on_crease = nullptr;  ///< per vertex: an edge between two of these follows a crease
  double shape = 0;                              ///< the price of 1 - Q for one vertex, as in AnglePrice; > 0
  int threads = 0;
  Progress progress = {};  ///< may be empty
};

/// The edges that are better flipped, each face at most once.
///
/// An edge is flipped where the sum of square distances from the surface and the price of Q of its two triangles falls.
/// So edges turn along creases, and away from vertices with many of them. Left as they are: edges that follow creases,
/// those between held vertices, and those at a vertex with three. No new edge joins vertices that have one, no new
/// triangle is flipped against the surface, has a smaller angle than both had if that is below kLeastFlippedAngle, or
/// intersects another. So the mesh stays one of the same topology. The best flips come first. Deterministic.
/// Cost: O(n log n), and O(1) closest points for each edge that might be better flipped.
std::vector<EdgeFlip> flip_edges(const FlipSearch& search, const Mesh& mesh);

/// New triangles have no angle below this, degrees, unless the old ones have a smaller one: for users, triangles below
/// 30 degrees are thin.
inline constexpr double kLeastFlippedAngle = 30;

}  // namespace gvd
