#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

// Walks around the vertices of a `Mesh` and along its boundary. Two data structures that are not a `Mesh` have walks of
// their own: the window propagation (geodesic/windows/vertex_fan.hpp), which stores faces together for the cache's
// sake, and the repair of soups, whose vertices may have several fans (mesh/repair/cut_apart.cpp).

/// The halfedge that leaves the same vertex in the next face counter-clockwise; invalid at the boundary.
inline HalfedgeId next_outgoing(const Mesh& mesh, HalfedgeId outgoing) { return mesh.twin(Mesh::previous(outgoing)); }

/// The halfedge that leaves the same vertex in the next face clockwise; invalid at the boundary.
inline HalfedgeId previous_outgoing(const Mesh& mesh, HalfedgeId outgoing) {
  const HalfedgeId twin = mesh.twin(outgoing);
  return twin.valid() ? Mesh::next(twin) : twin;
}

/// The halfedge after h along its boundary loop. h must lie on the boundary.
inline HalfedgeId next_on_boundary(const Mesh& mesh, HalfedgeId h) { return mesh.halfedge(mesh.to(h)); }

/// Calls visit(halfedge) for the first halfedge of each boundary loop, ascending.
template <class Visit>
void for_each_boundary_loop(const Mesh& mesh, const Visit& visit) {
  IdVector<HalfedgeId, char> visited(static_cast<std::size_t>(mesh.halfedge_count()), 0);
  for (const HalfedgeId first : mesh.halfedges()) {
    if (mesh.twin(first).valid() || visited[first]) continue;
    visit(first);
    for (HalfedgeId h = first; !visited[h]; h = next_on_boundary(mesh, h)) visited[h] = 1;
  }
}

/// Calls visit(halfedge) for every halfedge that leaves v, once, counter-clockwise from `mesh.halfedge(v)`.
template <class Visit>
void for_each_outgoing(const Mesh& mesh, VertexId v, Visit visit) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    visit(h);
    h = next_outgoing(mesh, h);
  } while (h.valid() && h != start);
}

/// Calls visit(neighbour, halfedge) for every edge at v, once. The halfedge lies on that edge, in one of v's faces.
template <class Visit>
void for_each_neighbour(const Mesh& mesh, VertexId v, Visit visit) {
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    visit(mesh.to(h), h);
    const HalfedgeId incoming = Mesh::previous(h);
    if (!mesh.twin(incoming).valid()) visit(mesh.from(incoming), incoming);
  });
}

/// Whether test(neighbour) holds for any vertex that an edge joins to v. Stops at the first such vertex.
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
