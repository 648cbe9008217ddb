#pragma once

#include <cstddef>

#include "cut_triangles.hpp"

namespace gvd {

/// Moves vertices apart that are corners of one triangle and have the same position, by a few times `reach`
/// (mesh units; see place_reach).
///
/// In a face without area the cuts through two of its sides can meet in one place, and stay two vertices: one on each
/// side. The vertices from `first_added` on may be moved, each along the longest edge in its parent; the
/// others, those of the input, stay. Returns how many rounds have moved a vertex; kPartingRounds where one more might.
/// Cost: O(k) for k triangles, times the rounds that it takes, which are few: at most kPartingRounds.
int part_coincident_corners(CutTriangles& cut, std::size_t first_added, double reach);

/// Each round moves by twice as much as the one before, so that two vertices that were moved onto each other, or onto a
/// third, are parted by the next. The last round moves by 2^19 times the reach, 5e-10 of the largest coordinate: more
/// would be a shift that matters.
inline constexpr int kPartingRounds = 20;

}  // namespace gvd
