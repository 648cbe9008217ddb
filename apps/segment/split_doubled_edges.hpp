#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The triangles of a cut mesh before they become one. Those of one parent stand together, and in it those of one
/// polygon.
struct CutTriangles {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  IdVector<FaceId, FaceId> parent;
  IdVector<FaceId, GeneratorId> label;
  IdVector<FaceId, std::int32_t> polygon;  ///< which polygon of all parents it is a part of, ascending
};

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
