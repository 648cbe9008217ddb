#pragma once

#include <array>
#include <cstddef>
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

/// Where the triangles of the parent of triangle `first` end. Cost: O(triangles of the parent).
inline std::size_t end_of_parent(const CutTriangles& cut, std::size_t first) {
  const auto parent = [&cut](std::size_t t) { return cut.parent[FaceId(static_cast<std::int64_t>(t))]; };
  std::size_t last = first;
  while (last < cut.faces.size() && parent(last) == parent(first)) ++last;
  return last;
}

}  // namespace gvd
