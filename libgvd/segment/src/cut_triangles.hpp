#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The triangles of a cut mesh before it is built. The triangles of a parent are consecutive, and so are those of a
/// polygon.
struct CutTriangles {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  IdVector<FaceId, FaceId> parent;
  IdVector<FaceId, GeneratorId> label;
  IdVector<FaceId, std::int32_t> polygon;  ///< the polygon that contains the triangle, numbered over all parents
};

/// The end of the range of triangles that begins at `first` and has one parent. Cost: O(triangles of the parent).
inline std::size_t end_of_parent(const CutTriangles& cut, std::size_t first) {
  const auto parent = [&cut](std::size_t t) { return cut.parent[FaceId(t)]; };
  std::size_t last = first;
  while (last < cut.faces.size() && parent(last) == parent(first)) ++last;
  return last;
}

}  // namespace gvd
