#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_limit.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// A window that has been carried across its face and stays on its edge. The frame is that of Rays.
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

/// A sequence that grows without moving what it holds, up to kMostWindows.
template <class T>
class BlockList {
 public:
  void push_back(const T& value) {
    if (size_ == blocks_.size() * kBlock) add_block();
    blocks_[size_ / kBlock][size_ % kBlock] = value;
    ++size_;
  }
  /// Puts the blocks of another list behind its own ones, and returns the place of the first of its items. Places
  /// between that and the former last item hold nothing.
  std::size_t append(BlockList other) {
    const std::size_t first = blocks_.size() * kBlock;
    for (auto& block : other.blocks_) blocks_.push_back(std::move(block));
    check_window_count(first, other.size_);
    size_ = first + other.size_;
    return first;
  }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return blocks_[i / kBlock][i % kBlock]; }

 private:
  void add_block() {
    check_window_count(size_, kBlock);
    blocks_.push_back(std::make_unique_for_overwrite<T[]>(kBlock));
  }

  static constexpr std::size_t kBlock = 256;
  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t size_ = 0;
};

/// A first-in-first-out queue that gives its items back a block at a time and uses its memory again.
template <class T>
class BlockQueue {
 public:
  static constexpr std::size_t kBlock = 256;

  bool empty() const { return blocks_.empty(); }
  /// Number of blocks.
  std::size_t age() const { return blocks_.size(); }

  /// Whether a block was filled before.
  bool push_back(const T& value) {
    const bool full = end_ == kBlock;
    if (full || blocks_.empty()) {
      if (spare_.empty()) spare_.push_back(std::make_unique_for_overwrite<T[]>(kBlock));
      blocks_.push_back(std::move(spare_.back()));
      spare_.pop_back();
      end_ = 0;
    }
    blocks_.back()[end_++] = value;
    return full;
  }
  /// Calls visit(const T&) for the items of the oldest block and removes them; `visit` may add items. Some items
  /// before, look_ahead(const T&) is called, which may get what visit will read into the cache.
  template <class Visit, class LookAhead>
  void take_block(Visit visit, LookAhead look_ahead) {
    std::unique_ptr<T[]> block = std::move(blocks_.front());
    const std::size_t count = blocks_.size() == 1 ? end_ : kBlock;
    blocks_.pop_front();
    for (std::size_t i = 0; i < count; ++i) {
      if (i + kAhead < count) look_ahead(block[i + kAhead]);
      visit(block[i]);
    }
    if (spare_.size() < kSpare) spare_.push_back(std::move(block));
  }
  template <class Visit>
  void take_block(Visit visit) {
    take_block(visit, [](const T&) {});
  }

 private:
  static constexpr std::size_t kAhead = 8;
  /// Blocks that are kept for use again. More would stay with a queue that needs them no more while others do.
  static constexpr std::size_t kSpare = 2;

  std::deque<std::unique_ptr<T[]>> blocks_;
  std::vector<std::unique_ptr<T[]>> spare_;
  std::size_t end_ = 0;  // in the last block
};

/// Windows by halfedge.
class EdgeWindows {
 public:
  EdgeWindows() = default;
  /// Windows of one halfedge stay in their order. No face may have windows in two lists, so that one thread can sort
  /// each. Cost: O(windows + faces).
  EdgeWindows(std::vector<BlockList<KeptWindow>> lists, std::size_t faces, const ParallelChunks& parallel)
      : first_(faces + 1, 0) {
    std::vector<Chunk> places;
    for (BlockList<KeptWindow>& list : lists) {
      const std::size_t begin = windows_.append(std::move(list));
      places.push_back({begin, windows_.size()});
    }
    const StepPart end{"distances"};
    parallel.run(places.size(), end, [&](std::size_t list) {
      for (std::size_t i = places[list].begin; i < places[list].end; ++i) ++first_[face(i) + 1];
    });
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    order_.resize(static_cast<std::size_t>(first_[faces]));
    parallel.run(places.size(), end, [&](std::size_t list) {
      for (std::size_t i = places[list].begin; i < places[list].end; ++i) {
        order_[static_cast<std::size_t>(first_[face(i)]++)] = static_cast<std::int32_t>(i);
      }
    });
    for (std::size_t f = faces; f > 0; --f) first_[f] = first_[f - 1];
    first_[0] = 0;
  }

  std::size_t size() const { return order_.size(); }

  /// Calls visit(const KeptWindow&) for the windows on the three halfedges of face f: those that cross into it, and
  /// where the halfedge lies on the boundary, those that end there.
  template <class Visit>
  void for_each(FaceId f, Visit visit) const {
    for (std::int32_t i = first_[f.index()]; i < first_[f.index() + 1]; ++i) {
      visit(windows_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])]);
    }
  }
  /// The same for one halfedge.
  template <class Visit>
  void for_each(HalfedgeId h, Visit visit) const {
    for_each(Mesh::face(h), [&](const KeptWindow& w) {
      if (w.halfedge == h.value()) visit(w);
    });
  }

 private:
  std::size_t face(std::size_t i) const { return static_cast<std::size_t>(windows_[i].halfedge / 3); }

  BlockList<KeptWindow> windows_;
  std::vector<std::int32_t> first_;  // [face] place of its first window in order_
  std::vector<std::int32_t> order_;  // places of windows, by face
};

}  // namespace gvd
