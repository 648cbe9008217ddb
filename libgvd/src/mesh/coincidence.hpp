#pragma once

#include <algorithm>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A position is rounded by up to half of this part of its largest coordinate (2^-53), and the difference of two by
/// four and a half times as much: points so near to each other can't be told apart far from the origin.
inline constexpr double kPositionRounding = 1e-15;

/// Generators closer than this coincide, mesh units.
inline double coincidence(const Mesh& mesh) {
  return std::max(kCoincidence * mesh.bbox_diagonal(), kPositionRounding * mesh.largest_coordinate());
}

}  // namespace gvd
