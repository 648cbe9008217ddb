#pragma once

#include "cut_triangles.hpp"

namespace gvd {

/// Splits each edge inside a parent at its midpoint if another edge joins the same two vertices: inside another parent,
/// on the border of a parent, or inside another polygon.
///
/// Such edges would become one edge with four faces. They occur in two ways. Two parents with the same three corners
/// are cut between the same points of their sides. Or two polygons on both sides of a bisector, whose points rounding
/// has made collinear, have the same diagonal. Each split adds one vertex, and two faces after those of the parent.
/// Cost: O(k log k) for the k triangles of parents that are cut, and O(n) in all.
void split_doubled_edges(CutTriangles& cut);

}  // namespace gvd
