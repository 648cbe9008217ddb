// Pairs halfedges, and finds the edges where there are more than two.
#include "mesh/repair/repair_soup.hpp"

namespace gvd {

EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count) {
  EdgeTable crowded;
  work.twin.assign(static_cast<std::size_t>(work.halfedge_count()), -1);
  visit_edges(work, vertex_count, [&](const EdgeHalfedges& edge) {
    if (edge.size() > 2) crowded.add(edge);
    if (edge.size() != 2) return;
    work.twin[static_cast<std::size_t>(edge[0])] = edge[1];
    work.twin[static_cast<std::size_t>(edge[1])] = edge[0];
  });
  return crowded;
}

}  // namespace gvd
