#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

/// Calls visit(g) for every face g that shares an edge with f; twice for one that shares two edges.
template <class Visit>
void for_each_adjacent_face(const Mesh& mesh, FaceId f, Visit visit) {
  for (int corner = 0; corner < 3; ++corner) {
    const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
    if (twin.valid()) visit(Mesh::face(twin));
  }
}

}  // namespace gvd
