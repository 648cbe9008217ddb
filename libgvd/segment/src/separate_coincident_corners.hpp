#pragma once

#include <cstddef>

#include "cut_triangles.hpp"

namespace gvd {

/// Moves corners of a triangle apart that have the same position, by a small multiple of `tolerance` (mesh units; see
/// position_tolerance).
///
/// In a face without area, cuts through two of its sides can have the same position but are different vertices, one on
/// each side. Vertices from `first_added` on may move, each along the longest edge of its parent; the vertices of the
/// input don't. Returns the number of rounds that moved a vertex; with kMaxSeparationRounds some may still coincide.
/// Cost: O(k) for k triangles in each of a few rounds.
int separate_coincident_corners(CutTriangles& cut, std::size_t first_added, double tolerance);

/// Each round moves by twice the length of the one before. It separates vertices that the last one moved onto each
/// other or onto a third. The last round moves by 2^19 times the tolerance, 5e-10 of the largest coordinate; a longer
/// move would change the shape.
inline constexpr int kMaxSeparationRounds = 20;

}  // namespace gvd
