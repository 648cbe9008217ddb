#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

/// Calls visit(halfedge) for every halfedge that leaves v, once round v.
template <class Visit>
void for_each_outgoing(const Mesh& mesh, VertexId v, Visit visit) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    visit(h);
    h = mesh.twin(Mesh::previous(h));
  } while (h.valid() && h != start);
}

/// Calls visit(neighbour, halfedge) for every edge at v; the halfedge lies on that edge, in one of v's faces.
template <class Visit>
void for_each_neighbour(const Mesh& mesh, VertexId v, Visit visit) {
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    visit(mesh.to(h), h);
    const HalfedgeId incoming = Mesh::previous(h);
    if (!mesh.twin(incoming).valid()) visit(mesh.from(incoming), incoming);
  });
}

/// Whether test(neighbour) holds for a vertex that an edge joins to v; looks no further than the first one.
template <class Test>
bool any_neighbour(const Mesh& mesh, VertexId v, Test test) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    if (test(mesh.to(h))) return true;
    const HalfedgeId incoming = Mesh::previous(h);
    h = mesh.twin(incoming);
    if (!h.valid()) return test(mesh.from(incoming));
  } while (h != start);
  return false;
}

}  // namespace gvd
