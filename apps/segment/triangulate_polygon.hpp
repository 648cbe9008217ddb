#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Cuts a simple polygon, counter-clockwise, into triangles along diagonals. Corners on a line with their neighbours
/// are ordinary. Returns corner numbers, three a triangle, counter-clockwise: always corners - 2 of them. Of all ears
/// the roundest is cut; where rounding leaves no ear of positive area, the corner with the largest area of all.
/// Source: ear clipping (Meisters 1975). Cost: O(n^2) worst, O(n log n) in practice.
std::vector<std::array<std::size_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

}  // namespace gvd
