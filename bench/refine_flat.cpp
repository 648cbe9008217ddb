#include "refine_flat.hpp"

#include <array>
#include <utility>
#include <vector>

namespace gvd::bench {

Mesh refine_flat(const Mesh& mesh) {
  std::vector<Vec3> positions = mesh.positions();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    positions.push_back((mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))) / 2);
  }
  std::vector<std::array<VertexId, 3>> faces;
  faces.reserve(4 * static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    std::array<VertexId, 3> middle;
    for (int i = 0; i < 3; ++i) {
      const EdgeId e = mesh.edge(Mesh::halfedge(FaceId(f), i));
      middle[i] = VertexId(std::int64_t{mesh.vertex_count()} + e.value());
    }
    const auto& [ab, bc, ca] = middle;
    faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace gvd::bench
