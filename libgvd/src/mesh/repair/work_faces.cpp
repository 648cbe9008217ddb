// Pairs the halfedges of triangles whose edges may have any number of faces.
#include "mesh/repair/work_faces.hpp"

#include "mesh/visit_edges.hpp"

namespace gvd {

EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count) {
  EdgeTable nonmanifold_edges;
  work.twin.assign(work.halfedge_count(), -1);
  visit_edges(work.faces, vertex_count, [&](const EdgeHalfedges& edge) {
    if (edge.size() > 2) nonmanifold_edges.push_back(edge.list());
    if (edge.size() == 2) work.link(edge[0], edge[1]);
  });
  return nonmanifold_edges;
}

}  // namespace gvd
