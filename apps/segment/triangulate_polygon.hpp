#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Cuts a simple polygon, counter-clockwise, into triangles along diagonals. Corners on a line with their neighbours
/// are ordinary. Returns corner numbers, three a triangle, counter-clockwise: always corners - 2 of them. Where
/// rounding leaves no ear of positive area, the ear with the largest area of all is cut. Source: ear clipping (Meisters
/// 1975). Cost: O(n^3) worst, O(n^2) in practice.
std::vector<std::array<std::size_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

}  // namespace gvd
