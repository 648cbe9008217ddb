#pragma once

#include <cstdint>
#include <vector>

#include "geodesic/face_frames.hpp"
#include "geodesic/window_lists.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// What window propagation leaves: exact distances at the vertices, and the windows on the edges.
struct WindowField {
  FaceFrames frames;
  IdVector<VertexId, double> distance;    ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, std::int32_t> label; ///< GeneratorId of the nearest generator, or -1
  WindowPool pool;
  std::vector<std::int32_t> kept;         ///< [halfedge] the last one of a closed list of windows, or -1
  std::int64_t window_count = 0;          ///< windows that were carried across a face
  std::int64_t created_count = 0;

  explicit WindowField(const Mesh& mesh)
      : frames(mesh),
        distance(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity()),
        label(static_cast<std::size_t>(mesh.vertex_count()), -1),
        kept(static_cast<std::size_t>(mesh.halfedge_count()), -1) {}

  /// Calls visit(const Window&) for the windows that cross halfedge h into its face; for a halfedge of the boundary, those
  /// that end there.
  std::int64_t count_kept() const {
    std::int64_t n = 0;
    for (std::size_t h = 0; h < kept.size(); ++h) for_each_window(HalfedgeId(std::int64_t(h)), [&](const Window&) { ++n; });
    return n;
  }
  template <class Visit>
  void for_each_window(HalfedgeId h, Visit visit) const {
    const std::int32_t last = kept[h.index()];
    if (last < 0) return;
    std::int32_t i = last;
    do {
      i = pool[i].next;
      visit(pool[i]);
    } while (i != last);
  }
};

}  // namespace gvd
