#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Takes points of a mesh to the mesh that flips of its edges make of it, one-to-one.
///
/// A flip maps its two faces as if they were the halves of a square: the sides of the square stay, and the map is
/// affine on the four triangles into which the two diagonals cut it. So a point on no flipped face stays.
class FlipFollower {
 public:
  /// `before` has the faces of undo_flips, and `after` those of apply_flips. All arguments must outlive this. Cost:
  /// O(n).
  FlipFollower(const Mesh& before, const Mesh& after, const std::vector<EdgeFlip>& flips);

  /// The point of `after` for one of `before`. Cost: O(1) for each flip of its faces.
  SurfacePoint follow(const SurfacePoint& point) const;

 private:
  const Mesh& before_;
  const Mesh& after_;
  const std::vector<EdgeFlip>& flips_;
  IdVector<FaceId, std::vector<std::size_t>> flips_of_;  // ascending
};

}  // namespace gvd
