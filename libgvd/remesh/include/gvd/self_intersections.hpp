#pragma once

#include <compare>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Two faces of a mesh, first < second.
struct FacePair {
  FaceId first, second;
  auto operator<=>(const FacePair&) const = default;
};

/// The pairs of faces that have a common point outside of the vertex or edge that they share, ascending.
///
/// Faces that only touch intersect, too.
/// Properties: (1) exact, unless products of three coordinates underflow; (2) empty exactly where the mesh is embedded,
/// if no face is degenerate; (3) independent of `threads` (0: one a core).
/// Throws Error{interrupted} if `progress` cancels.
/// Cost: O(n log n) where faces overlap the boxes of a bounded number of others.
std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads = 0, const Progress& progress = {});

/// The pairs of faces of a remesh that intersect where the surface intersects itself, ascending.
///
/// They are those near an intersecting pair of the surface, where a remesh can't be free of intersections. Take the
/// common part of the boxes of the remesh's two faces, grown on all sides by half the longer diagonal of the two boxes.
/// The pairs are near each other if it overlaps the boxes of both faces of the surface's pair. `pairs` are
/// those of find_self_intersections. Cost: that of find_self_intersections of the surface, and O(p log q) as a rule
/// for p and q pairs of the two; none without pairs. Throws Error{interrupted} if `progress` cancels.
std::vector<FacePair> find_inherited(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     int threads = 0, const Progress& progress = {});

}  // namespace gvd
