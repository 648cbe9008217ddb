#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
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
  BlockList<Departure> departures;  ///< departures of the windows, or empty
};

/// The windows that were kept on the edges of a mesh, by face and halfedge.
class EdgeWindows {
 public:
  EdgeWindows() = default;
  /// Windows of the same halfedge keep their order. No face may have windows in two lists, because each list is sorted
  /// by its own thread. Cost: O(windows + faces).
  EdgeWindows(std::vector<KeptWindows> lists, std::size_t faces, const ParallelChunks& parallel) : of_face_(faces) {
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
    visit_all([&](std::size_t i) { ++of_face_[face(i)].end; });
    std::int32_t count = 0;
    for (Range& range : of_face_) {
      range.begin = count;
      count += std::exchange(range.end, count);
    }
    order_.resize(count);
    visit_all([&](std::size_t i) { order_[of_face_[face(i)].end++] = static_cast<std::int32_t>(i); });
  }

  /// Sorts the windows of each face by their members, because windows near bisectors are kept in an order that depends
  /// on which windows were kept elsewhere.
  void sort(const ParallelChunks& parallel) {
    const std::vector<Chunk> faces = cut_into_chunks(of_face_.size(), kScanChunk);
    parallel.run(faces.size(), {steps::kDistances}, [&](std::size_t chunk) {
      for (std::size_t f = faces[chunk].begin; f < faces[chunk].end; ++f) sort(of_face_[f]);
    });
  }

  /// Replaces the windows of face f, without departures. The memory of the old windows is not reused until `packed` is
  /// called.
  void replace(FaceId f, std::span<const Window> windows) {
    const auto begin = static_cast<std::int32_t>(order_.size());
    for (const Window& w : windows) {
      order_.push_back(static_cast<std::int32_t>(windows_.size()));
      windows_.push_back(w);
    }
    of_face_[f.index()] = {begin, static_cast<std::int32_t>(order_.size())};
  }
  /// Adds faces without windows, or removes the last faces.
  void resize(std::size_t faces) { of_face_.resize(faces); }
  /// The same windows in as little memory as they need. Cost: O(windows + faces).
  EdgeWindows packed() const {
    EdgeWindows result;
    result.resize(of_face_.size());
    std::vector<Window> windows;
    for (std::size_t f = 0; f < of_face_.size(); ++f) {
      windows.clear();
      for_each(FaceId(f), [&](const Window& w) { windows.push_back(w); });
      result.replace(FaceId(f), windows);
    }
    return result;
  }

  /// Number of windows, including replaced ones.
  std::size_t size() const { return order_.size(); }

  /// Numbers of the windows of face f. Numbers are below size(), and the windows of one face follow each other.
  Chunk of_face(FaceId f) const {
    const Range& range = of_face_[f.index()];
    return {static_cast<std::size_t>(range.begin), static_cast<std::size_t>(range.end)};
  }
  const Window& operator[](std::size_t number) const { return windows_[order_[number]]; }
  /// Prefetches a window and, if departures were recorded, its departure. Does nothing for numbers beyond the last
  /// window.
  void prefetch_window(std::size_t number) const {
    if (number >= order_.size()) return;
    const std::size_t i = order_[number];
    prefetch(&windows_[i]);
    if (departures_.size() > 0) prefetch(&departures_[i]);
  }
  /// The departure of a window. Departures must have been recorded.
  Departure departure(std::size_t number) const { return departures_[order_[number]]; }

  /// Calls visit(const Window&) for the windows on the three halfedges of face f: those that enter it, and on the
  /// boundary those that end there.
  template <class Visit>
  void for_each(FaceId f, Visit visit) const {
    const Range& range = of_face_[f.index()];
    for (std::int32_t i = range.begin; i < range.end; ++i) visit(windows_[order_[i]]);
  }
  /// The same for one halfedge.
  template <class Visit>
  void for_each(HalfedgeId h, Visit visit) const {
    for_each(Mesh::face(h), [&](const Window& w) {
      if (w.halfedge == h) visit(w);
    });
  }

 private:
  struct Range {
    std::int32_t begin = 0, end = 0;
  };
  /// Up to this many windows are sorted by insertion, because in lists of about six, function calls would cost more
  /// than comparisons.
  static constexpr std::int32_t kFewWindows = 24;

  std::size_t face(std::size_t i) const { return Mesh::face(windows_[i].halfedge).index(); }
  static bool precedes(const Window& a, const Window& b) {
    if (a.x != b.x) return a.x < b.x;
    return std::tie(a.halfedge, a.begin, a.end, a.depth, a.offset, a.generator) <
           std::tie(b.halfedge, b.begin, b.end, b.depth, b.offset, b.generator);
  }
  void sort(const Range& range) {
    if (range.end - range.begin > kFewWindows) {
      std::sort(order_.begin() + range.begin, order_.begin() + range.end,
                [&](std::int32_t i, std::int32_t j) { return precedes(windows_[i], windows_[j]); });
      return;
    }
    std::array<double, kFewWindows> keys;  // x of the windows in their order, so that each is looked up once
    for (std::int32_t i = range.begin, count = 0; i < range.end; ++i, ++count) {
      const std::int32_t inserted = order_[i];
      const double key = windows_[inserted].x;
      std::int32_t at = count;
      for (; at > 0; --at) {
        const std::int32_t before = order_[range.begin + at - 1];
        if (keys[at - 1] < key) break;
        if (keys[at - 1] == key && !precedes(windows_[inserted], windows_[before])) break;
        keys[at] = keys[at - 1];
        order_[range.begin + at] = before;
      }
      keys[at] = key;
      order_[range.begin + at] = inserted;
    }
  }

  BlockList<Window> windows_;
  BlockList<Departure> departures_;  // departures of windows_, or empty
  std::vector<Range> of_face_;       // [face] range of its windows in order_
  std::vector<std::int32_t> order_;  // indices of windows, by face
};

/// The result of window propagation: exact distances at the vertices, and windows on the edges.
struct WindowField {
  IdVector<VertexId, double> distance;      ///< mesh units; infinity if no generator reaches
  IdVector<VertexId, GeneratorId> label;    ///< the nearest generator; invalid if none reaches
  IdVector<VertexId, Departure> departure;  ///< departure of the shortest path, if departures are recorded
  IdVector<FaceId, FaceFrame> frame;        ///< frames of all faces, if departures are recorded
  CornerAngles angles;                      ///< angles of the working mesh, if departures are recorded
  EdgeWindows windows;
  StartDistances starts;     ///< if departures are recorded
  std::int64_t carried = 0;  ///< number of windows that were carried across a face; the time is proportional to it
  std::int64_t events = 0;   ///< number of generators and pseudo-sources that sent windows
};

}  // namespace gvd
