#include "geodesic/window_distances.hpp"

#include "geodesic/window_sources.hpp"

namespace gvd {

std::vector<EdgeId> WindowDistances::contested_edges() const {
  std::vector<char> contested(static_cast<std::size_t>(mesh_.edge_count()), 0);
  for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
    field_.windows.for_each(FaceId(i), [&](const KeptWindow& w) {
      const HalfedgeId h(w.halfedge);
      const GeneratorId g(w.generator);
      if (field_.label[mesh_.from(h)] != g || field_.label[mesh_.to(h)] != g) contested[mesh_.edge(h).index()] = 1;
    });
  }
  std::vector<EdgeId> edges;
  for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
    const HalfedgeId h = mesh_.halfedge(EdgeId(i));
    if (contested[EdgeId(i).index()] != 0 || field_.label[mesh_.from(h)] != field_.label[mesh_.to(h)]) {
      edges.push_back(EdgeId(i));
    }
  }
  return edges;
}

void WindowDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  collect_edge_sources(mesh_, field_, mesh_.halfedge(e), sources);
}

void WindowDistances::collect(FaceId f, std::vector<FaceSource>& sources) const {
  collect_face_sources(mesh_, field_, f, sources);
}

}  // namespace gvd
