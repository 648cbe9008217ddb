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

}  // namespace gvd
