#include "diagram/crossings.hpp"

namespace gvd {

std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings) {
  std::vector<char> is_crossed(static_cast<std::size_t>(mesh.face_count()), 0);
  for (const Crossing& c : crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge), twin = mesh.twin(h);
    is_crossed[Mesh::face(h).index()] = 1;
    if (twin.valid()) is_crossed[Mesh::face(twin).index()] = 1;
  }
  std::vector<FaceId> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (is_crossed[FaceId(f).index()]) faces.push_back(FaceId(f));
  }
  return faces;
}

}  // namespace gvd
