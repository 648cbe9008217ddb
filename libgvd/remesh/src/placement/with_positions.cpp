#include "placement/with_positions.hpp"

#include <utility>

namespace gvd {

Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions) {
  std::vector<std::array<VertexId, 3>> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return {std::move(positions), std::move(faces)};
}

}  // namespace gvd
