#include "geodesic/windows/field/window_distances.hpp"

#include <cstdint>

#include "geodesic/windows/field/collect_sources.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {

std::vector<EdgeId> WindowDistances::contested_edges(const ParallelChunks& parallel) const {
  // Of each halfedge, whether it has a window of another label than its start: each window is read once.
  std::vector<std::uint8_t> has_other(static_cast<std::size_t>(mesh_.halfedge_count()), 0);
  const auto faces = cut_into_chunks(static_cast<std::size_t>(mesh_.face_count()), kScanChunk);
  parallel.run(faces.size(), steps::kLabels, [&](std::size_t chunk) {
    for (std::size_t f = faces[chunk].begin; f < faces[chunk].end; ++f) {
      field_.windows.for_each(FaceId(f), [&](const Window& w) {
        const GeneratorId label = field_.label[mesh_.from(w.halfedge)];
        if (w.generator != label) has_other[w.halfedge.index()] = 1;
      });
    }
  });
  return find_edges(mesh_, parallel, [&](EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
    return field_.label[mesh_.from(h)] != field_.label[mesh_.to(h)] || has_other[h.index()] != 0 ||
           (twin.valid() && has_other[twin.index()] != 0);
  });
}

void WindowDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  collect_edge_sources(mesh_, field_, mesh_.halfedge(e), sources);
}

void WindowDistances::collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const {
  collect_face_sources(mesh_, field_, f, layout, sources);
}

}  // namespace gvd
