#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd::io {

/// Triangles of a polygon by ear clipping, as indices of its corners.
///
/// Source:  G. H. Meisters, Polygons have ears, 1975; among the ears the best shaped one goes first, so that corners
///          on a straight side become corners of triangles and leave no gap to the neighbouring piece.
/// Inputs:  the corners of a simple polygon, counter-clockwise; sides may touch, corners may repeat
/// Returns: counter-clockwise triangles of positive area that cover it; none where it has no area
/// Cost:    O(n^2) time for convex polygons, O(n^3) at worst, O(n) memory, for n corners
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

}  // namespace gvd::io
