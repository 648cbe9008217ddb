#pragma once

#include <array>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The triangles of a cut mesh before they become one. Those of one parent stand together.
struct CutTriangles {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  IdVector<FaceId, FaceId> parent;
  IdVector<FaceId, GeneratorId> label;
};

/// Splits, at its midpoint, each edge inside a parent whose two ends are also joined elsewhere: inside another parent,
/// or along a border.
///
/// Two parents with the same three corners, which lie on each other, are cut between the same points of their sides;
/// those cuts would be one edge with four faces. Each split adds two faces behind the parent's own, and one vertex.
/// Cost: O(k log k) for the k triangles of parents that are cut, and O(n) in all.
void split_doubled_edges(CutTriangles& cut);

}  // namespace gvd
