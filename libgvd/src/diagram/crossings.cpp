#include "diagram/crossings.hpp"

#include <algorithm>

namespace gvd {

std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings) {
  std::vector<FaceId> faces;
  for (const Crossing& c : crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge);
    faces.push_back(Mesh::face(h));
    if (mesh.twin(h).valid()) faces.push_back(Mesh::face(mesh.twin(h)));
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace gvd
