#include "geodesic/window_distances.hpp"

#include "geodesic/window_sources.hpp"

namespace gvd {

bool WindowDistances::is_contested(EdgeId e) const {
  const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
  const GeneratorId label = field_.label[mesh_.from(h)];
  bool contested = field_.label[mesh_.to(h)] != label;
  const auto look = [&](const KeptWindow& w) { contested = contested || GeneratorId(w.generator) != label; };
  field_.windows.for_each(h, look);
  if (twin.valid()) field_.windows.for_each(twin, look);
  return contested;
}

void WindowDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  collect_edge_sources(mesh_, field_, mesh_.halfedge(e), sources);
}

void WindowDistances::collect(FaceId f, std::vector<FaceSource>& sources) const {
  collect_face_sources(mesh_, field_, f, sources);
}

}  // namespace gvd
