#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::paper {

using Corners = std::array<VertexId, 3>;

/// The corners of all faces, in the order of their ids.
inline std::vector<Corners> list_faces(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return faces;
}

}  // namespace gvd::paper
