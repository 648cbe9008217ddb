#pragma once

#include <compare>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// Two faces of a mesh, first < second.
struct FacePair {
  FaceId first, second;
  auto operator<=>(const FacePair&) const = default;
};

/// The pairs of faces that have a common point outside of the vertex or edge that they share, ascending.
///
/// Faces that only touch intersect, too. Properties: (1) exact, unless products of three coordinates underflow;
/// (2) empty exactly where the mesh is embedded, if no face is degenerate; (3) independent of `threads` (0: one a
/// core).
/// Cost: O(n log n) where faces overlap the boxes of a bounded number of others.
std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads = 0);

/// Of the pairs of faces of a remesh that intersect, those that intersect where the surface does itself, ascending.
///
/// They are those near an intersecting pair of the surface. Near means: take the part that the boxes of the remesh's
/// two faces have in common, grown on all sides by half the longer diagonal of the two. It overlaps the boxes of both
/// faces of the pair. A remesh can't be free of intersections there. Cost: that of find_self_intersections of the
/// surface; none without pairs.
std::vector<FacePair> find_inherited(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     int threads = 0);

}  // namespace gvd
