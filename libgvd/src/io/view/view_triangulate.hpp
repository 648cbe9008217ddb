#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd::io {

/// Triangles of a polygon by ear clipping, as indices of its corners: those of triangulate_plane_polygon with a visible
/// area.
///
/// Inputs:  the corners of a simple polygon, counter-clockwise; sides may touch, corners may repeat
/// Returns: counter-clockwise triangles of positive area that cover it; none where it has no area
/// Cost:    O(n^2) worst, O(n log n) in practice, for n corners
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

}  // namespace gvd::io
