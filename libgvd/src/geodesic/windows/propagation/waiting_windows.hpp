#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geodesic/windows/block_list.hpp"
#include "geodesic/windows/window.hpp"

namespace gvd {

/// The windows of one partition that wait to be carried across the faces beyond their edges: a list for every
/// halfedge.
///
/// The slot that was freed last is reused first, while the cache still holds it. Memory: 68 bytes times the largest
/// number of windows that have waited at the same time since the last `release`.
class WaitingWindows {
 public:
  /// `first` must be -1 for every halfedge of the mesh, and must outlive this object; only the items of the partition's
  /// halfedges are used. Keys that differ by at most `key_step` count as equal.
  WaitingWindows(IdVector<HalfedgeId, std::int32_t>& first, double key_step)
      : first_(first.raw().data()), key_step_(key_step), key_unit_(std::ldexp(1.0, -std::ilogb(key_step))) {}

  /// Adds a window with the key `key` to the list of its halfedge, which is `length` long. Returns whether the halfedge
  /// has to be queued with that key: no window waited there, or the halfedge is queued with a larger key. It is always
  /// inlined, because it belongs to the innermost loop.
  [[gnu::always_inline]] bool add(const Window& w, const WindowHistory& history, double length, double key) {
    std::int32_t& head = first_[w.halfedge.value()];
    if (head >= 0 && history.joinable_ends != 0 && join(head, w, history, length)) return lower_key(head, key);
    const std::int32_t slot = take_slot();
    Entry& added = at(slot);
    // Members are stored one by one, because a copy in one piece would have to wait until the members have reached the
    // cache.
    added.begin = w.begin;
    added.end = w.end;
    added.x = w.x;
    added.depth = w.depth;
    added.offset = w.offset;
    added.generator = w.generator;
    added.history = history;
    if (head < 0) {
      next_[slot] = -1;
      added.key = static_cast<float>(key * key_unit_);
      head = slot;
      return true;
    }
    next_[slot] = next_[head];
    next_[head] = slot;
    return lower_key(head, key);
  }

  bool waits(HalfedgeId h) const { return first_[h.value()] >= 0; }

  void prefetch_list(HalfedgeId h) const { prefetch(first_ + h.value()); }
  /// Prefetches the first windows of a list.
  void prefetch_windows(HalfedgeId h) const {
    std::int32_t slot = first_[h.value()];
    for (int i = 0; i < kAhead && slot >= 0; ++i) slot = prefetched(slot);
  }

  /// Removes the windows of halfedge h and calls visit(const PropagatedWindow&) for each; `visit` may add windows to
  /// other halfedges. Always inlined, like `add`.
  template <class Visit>
  [[gnu::always_inline]] void take(HalfedgeId h, Visit visit) {
    std::int32_t slot = first_[h.value()], ahead = slot;
    first_[h.value()] = -1;
    for (int i = 0; i < kAhead && ahead >= 0; ++i) ahead = next_[ahead];
    while (slot >= 0) {
      if (ahead >= 0) ahead = prefetched(ahead);
      const Entry& entry = at(slot);
      const PropagatedWindow taken{{entry.begin, entry.end, entry.x, entry.depth, entry.offset, entry.generator, h},
                                   entry.history};
      const std::int32_t next = next_[slot];
      next_[slot] = free_;
      free_ = slot;
      visit(taken);
      slot = next;
    }
  }

  /// Frees the memory. No window may wait.
  void release() {
    blocks_ = std::vector<std::unique_ptr<Entry[]>>();
    next_ = std::vector<std::int32_t>();
    free_ = -1;
  }

 private:
  /// A waiting window, which fills one cache line. It has the members of Window except the halfedge, which the list
  /// determines.
  struct alignas(64) Entry {
    double begin, end, x, depth, offset;
    GeneratorId generator;
    WindowHistory history;
    float key;  ///< only in the first window of a list: the key of the halfedge in the queue, times key_unit_
  };
  static_assert(sizeof(Entry) == 64);

  /// Windows are prefetched this many ahead, because a cache line from memory takes as long as several windows.
  static constexpr int kAhead = 4;
  static constexpr int kShift = 8;
  static constexpr std::int32_t kMask = (1 << kShift) - 1;
  /// Interval ends that differ by less than this fraction of the edge count as the same.
  static constexpr double kSameEnd = 1e-9;

  [[gnu::always_inline]] const Entry& at(std::int32_t i) const {
    return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask];
  }
  [[gnu::always_inline]] Entry& at(std::int32_t i) { return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask]; }

  /// Prefetches a window, and returns the next one of its list.
  std::int32_t prefetched(std::int32_t slot) const {
    prefetch(&at(slot));
    return next_[slot];
  }

  [[gnu::always_inline]] std::int32_t take_slot() {
    if (free_ < 0) [[unlikely]]
      add_block();
    const std::int32_t slot = free_;
    free_ = next_[slot];
    return slot;
  }

  /// Adds a block of slots, which will be taken in ascending order.
  [[gnu::noinline]] void add_block() {
    check_window_count(next_.size(), kMask + 1);
    const auto begin = static_cast<std::int32_t>(next_.size()), end = begin + kMask + 1;
    blocks_.push_back(std::make_unique_for_overwrite<Entry[]>(kMask + 1));
    if (next_.size() == next_.capacity()) next_.reserve(next_.size() + next_.size() / 4 + kMask + 1);
    for (std::int32_t slot = begin; slot < end; ++slot) next_.push_back(slot + 1 < end ? slot + 1 : -1);
    free_ = begin;
  }

  [[gnu::always_inline]] bool lower_key(std::int32_t head, double key) {
    float& queued = at(head).key;
    if (!((key + key_step_) * key_unit_ < static_cast<double>(queued))) return false;
    queued = static_cast<float>(key * key_unit_);
    return true;
  }

  /// Joins the window with a waiting one if the two are neighbours with the same image because a flat vertex has split
  /// them. The joined window holds exactly the paths of both. Returns whether it was joined.
  bool join(std::int32_t head, const Window& w, const WindowHistory& history, double length) {
    constexpr std::uint32_t kBegin = WindowHistory::kAtBegin, kEnd = WindowHistory::kAtEnd;
    const double tolerance = kSameImage * (w.offset + w.depth + std::abs(w.x));
    for (std::int32_t i = head; i >= 0; i = next_[i]) {
      Entry& known = at(i);
      if (known.generator != w.generator || known.offset != w.offset) continue;
      if (std::abs(known.x - w.x) > tolerance || std::abs(known.depth - w.depth) > tolerance) continue;
      const std::uint32_t known_ends = known.history.joinable_ends, ends = history.joinable_ends;
      const std::uint32_t open = known_ends & ((ends >> 1) | (ends << 1));  // at its beginning, if our end is joinable
      if ((open & kEnd) && std::abs(known.end - w.begin) <= kSameEnd * length) {
        unite(known, w, history);
        known.history.joinable_ends = ((known_ends & kBegin) | (ends & kEnd)) & 3u;
        return true;
      }
      if ((open & kBegin) && std::abs(known.begin - w.end) <= kSameEnd * length) {
        unite(known, w, history);
        known.history.joinable_ends = ((known_ends & kEnd) | (ends & kBegin)) & 3u;
        return true;
      }
    }
    return false;
  }

  /// Either window can be narrower than kSameEnd, so the ends that meet do not tell which window comes first. Their
  /// paths have crossed different faces, so the history keeps only what holds for both.
  static void unite(Entry& entry, const Window& w, const WindowHistory& history) {
    entry.begin = std::min(entry.begin, w.begin);
    entry.end = std::max(entry.end, w.end);
    if (entry.history.cycle_check_face != history.cycle_check_face) entry.history.cycle_check_face = FaceId();
    if (history.crossed_faces < entry.history.crossed_faces) entry.history.crossed_faces = history.crossed_faces;
  }

  std::int32_t* first_;  // [halfedge] slot of the first entry, or -1
  std::vector<std::unique_ptr<Entry[]>> blocks_;
  /// [slot] the next slot in its list, or -1; free slots form a list, too. The table is separate from the entries so
  /// that the nearest cache holds it, and lists can be followed far ahead.
  std::vector<std::int32_t> next_;
  std::int32_t free_ = -1;
  double key_step_;
  double key_unit_;  // a power of two that brings the step near 1, so that keys neither vanish nor overflow as floats
};

}  // namespace gvd
