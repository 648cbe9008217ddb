#pragma once

#include <algorithm>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Positions closer than this fraction of the largest coordinate can't be told apart. Dimensionless. One position is
/// rounded by up to 2^-53 of its largest coordinate, and the distance of two by up to nine times as much.
inline constexpr double kCoordinateRounding = 1e-15;

/// Generators closer than this coincide, in mesh units: a fraction of the bounding box's diagonal, or, far from the
/// origin, the rounding error of positions.
inline double coincidence(const Mesh& mesh) {
  return std::max(kCoincidence * mesh.bbox_diagonal(), kCoordinateRounding * mesh.largest_coordinate());
}

}  // namespace gvd
