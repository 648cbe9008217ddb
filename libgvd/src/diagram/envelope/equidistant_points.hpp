#pragma once

#include <span>
#include <vector>

#include "geodesic/distance_field.hpp"

namespace gvd {

/// Appends the points equally far from a source of each of three generators, along straight lines from the images: two
/// at most for each triple. They are exact to rounding, or to half of the digits where two rays touch.
/// Cost: O(product of the numbers of sources).
void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points);

}  // namespace gvd
