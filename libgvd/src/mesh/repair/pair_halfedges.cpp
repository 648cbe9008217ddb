#include "mesh/repair/pair_halfedges.hpp"

namespace gvd {

EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count) {
  EdgeTable nonmanifold_edges;
  work.twin.assign(static_cast<std::size_t>(work.halfedge_count()), -1);
  visit_edges(work, vertex_count, [&](const EdgeHalfedges& edge) {
    if (edge.size() > 2) nonmanifold_edges.add(edge);
    if (edge.size() != 2) return;
    work.twin[edge[0]] = edge[1];
    work.twin[edge[1]] = edge[0];
  });
  return nonmanifold_edges;
}

}  // namespace gvd
