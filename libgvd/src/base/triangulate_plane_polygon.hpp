#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Cuts a simple polygon, counter-clockwise, into triangles along diagonals.
///
/// Source:  ear clipping (G. H. Meisters, Polygons have ears, 1975). Of all ears the roundest is cut, so that corners
///          on a straight side become corners of triangles with an area. Where rounding leaves no ear of positive area,
///          the corner with the largest signed area is cut
/// Inputs:  corners with coordinates in [0, 1]; sides may touch, corners may repeat
/// Returns: triangles of corner numbers, counter-clockwise: always two fewer than corners, none for fewer than three
/// Cost:    O(n^2) worst, O(n log n) in practice
std::vector<std::array<std::size_t, 3>> triangulate_plane_polygon(const std::vector<Vec2>& corners);

}  // namespace gvd
