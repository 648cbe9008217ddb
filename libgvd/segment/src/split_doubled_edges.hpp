#pragma once

#include "cut_triangles.hpp"

namespace gvd {

/// Splits, at its midpoint, each edge inside a parent whose two ends are also joined elsewhere: inside another parent,
/// along a border, or inside another polygon.
///
/// Two parents with the same three corners, which lie on each other, are cut between the same points of their sides;
/// those cuts would be one edge with four faces. So would be the diagonals of two polygons on both sides of a
/// bisector's points that rounding has put on one line. Each split adds two faces behind the parent's own, and one
/// vertex.
/// Cost: O(k log k) for the k triangles of parents that are cut, and O(n) in all.
void split_doubled_edges(CutTriangles& cut);

}  // namespace gvd
