#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/window.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// A window that has been carried across its face and stays on its edge. The frame is that of Window.
struct KeptWindow {
  double begin, end;       ///< interval on the edge, mesh units
  double x, depth;         ///< the image lies at (x, -depth)
  double offset;           ///< distance from the generator to the image's vertex
  std::int32_t generator;  ///< GeneratorId
  std::int32_t halfedge;   ///< that it crosses next; on the boundary that of the face it comes from

  /// Distance from the generator to the point t of the edge; a real path for t in [begin, end].
  double distance(double t) const { return offset + std::sqrt((t - x) * (t - x) + depth * depth); }
};
static_assert(sizeof(KeptWindow) == 48);

/// A sequence that grows without moving what it holds.
template <class T>
class BlockList {
 public:
  void push_back(const T& value) {
    if (size_ == blocks_.size() * kBlock) blocks_.push_back(std::make_unique_for_overwrite<T[]>(kBlock));
    blocks_.back()[size_++ % kBlock] = value;
  }
  template <class Iterator>
  void append(Iterator first, Iterator last) {
    for (; first != last; ++first) push_back(*first);
  }
  std::size_t size() const { return size_; }
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < size_; ++i) visit(blocks_[i / kBlock][i % kBlock]);
  }

 private:
  static constexpr std::size_t kBlock = 1024;
  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t size_ = 0;
};

/// Windows by face and halfedge.
class EdgeWindows {
 public:
  EdgeWindows() = default;
  /// Sorts by halfedge; windows of one halfedge stay in their order. Cost: O(windows + faces).
  EdgeWindows(BlockList<KeptWindow> windows, std::size_t faces) : first_(faces + 1, 0), windows_(windows.size()) {
    windows.for_each([&](const KeptWindow& w) { ++first_[face(w) + 1]; });
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    for (const std::int32_t corner : {0, 1, 2}) {
      windows.for_each([&](const KeptWindow& w) {
        if (w.halfedge % 3 == corner) windows_[static_cast<std::size_t>(first_[face(w)]++)] = w;
      });
    }
    for (std::size_t f = faces; f > 0; --f) first_[f] = first_[f - 1];
    if (faces > 0) first_[0] = 0;
  }

  /// The windows that cross halfedge h into its face; for a halfedge of the boundary, those that end there.
  std::span<const KeptWindow> on(HalfedgeId h) const {
    const std::span<const KeptWindow> all = in(Mesh::face(h));
    const auto before = [](const KeptWindow& w, std::int32_t value) { return w.halfedge < value; };
    const auto begin = std::lower_bound(all.begin(), all.end(), h.value(), before);
    return {begin, std::lower_bound(begin, all.end(), h.value() + 1, before)};
  }
  /// The windows on the three halfedges of face f.
  std::span<const KeptWindow> in(FaceId f) const {
    const auto begin = windows_.begin() + first_[f.index()];
    return {begin, windows_.begin() + first_[f.index() + 1]};
  }
  /// All of them, ascending by halfedge.
  const std::vector<KeptWindow>& all() const { return windows_; }

 private:
  static std::size_t face(const KeptWindow& w) { return static_cast<std::size_t>(w.halfedge / 3); }

  std::vector<std::int64_t> first_;  // [face] place of its first window
  std::vector<KeptWindow> windows_;
};

}  // namespace gvd
