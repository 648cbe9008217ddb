#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/block_list.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Windows that a partition keeps, in the order in which they were carried.
struct KeptWindows {
  BlockList<Window> windows;
  BlockList<Departure> departures;  ///< of the windows, or empty
};

/// The windows that were kept on the edges of a mesh, by face and halfedge.
class EdgeWindows {
 public:
  EdgeWindows() = default;
  /// Windows of one halfedge stay in their order. No face may have windows in two lists: each list is sorted by one
  /// thread. Cost: O(windows + faces).
  EdgeWindows(std::vector<KeptWindows> lists, std::size_t faces, const ParallelChunks& parallel)
      : first_(faces + 1, 0) {
    std::vector<Chunk> ranges;
    for (KeptWindows& list : lists) {
      const std::size_t begin = windows_.append(std::move(list.windows));
      departures_.append(std::move(list.departures));
      ranges.push_back({begin, windows_.size()});
    }
    const auto visit_all = [&](const auto& visit) {
      parallel.run(ranges.size(), {steps::kDistances}, [&](std::size_t list) {
        for (std::size_t i = ranges[list].begin; i < ranges[list].end; ++i) visit(i);
      });
    };
    visit_all([&](std::size_t i) { ++first_[face(i) + 1]; });
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    order_.resize(first_[faces]);
    visit_all([&](std::size_t i) { order_[first_[face(i)]++] = static_cast<std::int32_t>(i); });
    for (std::size_t f = faces; f > 0; --f) first_[f] = first_[f - 1];
    first_[0] = 0;
  }

  std::size_t size() const { return order_.size(); }

  /// Numbers of the windows of face f, from 0 to size(): those of one face follow each other.
  Chunk of_face(FaceId f) const {
    return {static_cast<std::size_t>(first_[f.index()]), static_cast<std::size_t>(first_[f.index() + 1])};
  }
  const Window& operator[](std::size_t number) const { return windows_[order_[number]]; }
  /// Lets the cache fetch a window, and its departure where they were recorded; nothing beyond the last one.
  void prefetch_window(std::size_t number) const {
    if (number >= order_.size()) return;
    const std::size_t i = order_[number];
    prefetch(&windows_[i]);
    if (departures_.size() > 0) prefetch(&departures_[i]);
  }
  /// The departure of a window. Only if departures were recorded.
  Departure departure(std::size_t number) const { return departures_[order_[number]]; }

  /// Calls visit(const Window&) for the windows on the three halfedges of face f: those that enter it, and on the
  /// boundary those that end there.
  template <class Visit>
  void for_each(FaceId f, Visit visit) const {
    for (std::int32_t i = first_[f.index()]; i < first_[f.index() + 1]; ++i) {
      visit(windows_[order_[i]]);
    }
  }
  /// The same for one halfedge.
  template <class Visit>
  void for_each(HalfedgeId h, Visit visit) const {
    for_each(Mesh::face(h), [&](const Window& w) {
      if (w.halfedge == h) visit(w);
    });
  }

 private:
  std::size_t face(std::size_t i) const { return Mesh::face(windows_[i].halfedge).index(); }

  BlockList<Window> windows_;
  BlockList<Departure> departures_;  // of windows_, or empty
  std::vector<std::int32_t> first_;  // [face] index of its first window in order_
  std::vector<std::int32_t> order_;  // indices of windows, by face
};

/// The result of window propagation: exact distances at the vertices, and windows on the edges.
struct WindowField {
  IdVector<VertexId, double> distance;      ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, GeneratorId> label;    ///< the nearest generator; invalid where none reaches
  IdVector<VertexId, Departure> departure;  ///< of the shortest path, if departures are recorded
  IdVector<FaceId, FaceFrame> frame;        ///< of all faces, if departures are recorded
  CornerAngles angles;                      ///< of the working mesh, if departures are recorded
  EdgeWindows windows;
  StartDistances starts;     ///< if departures are recorded
  std::int64_t carried = 0;  ///< number of windows that were carried across a face; the time is proportional to it
  std::int64_t events = 0;   ///< number of generators and pseudo-sources that sent windows
};

}  // namespace gvd
