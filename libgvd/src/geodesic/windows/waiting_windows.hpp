#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/prefetch.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_limit.hpp"

namespace gvd {

/// The windows of one part of the mesh that wait to be carried across the faces beyond their edges: a list for every
/// halfedge.
///
/// Their places are used again in the order last out, first in, while the cache still holds them.
/// Memory: 64 bytes for each of the most windows that have waited at once since the last `release`.
class WaitingWindows {
 public:
  /// `first`: -1 for every halfedge of the mesh; has to outlive this. Only those of the part's halfedges are touched.
  /// `key_step`: keys that differ by no more than this count as equal.
  WaitingWindows(std::vector<std::int32_t>& first, double key_step)
      : first_(first.data()), key_step_(key_step), key_unit_(std::ldexp(1.0, -std::ilogb(key_step))) {}

  /// Adds a window with the key `key` to the list of halfedge h, which is `length` long. Returns whether the halfedge
  /// has to be queued with that key: nothing waited there, or what waited has a later one.
  /// Inlined, whatever compilers estimate: it belongs to the innermost loop.
  [[gnu::always_inline]] bool add(std::int32_t h, const Rays& rays, const Origin& origin, double length, double key) {
    std::int32_t& head = first_[h];
    if (head >= 0 && origin.joins != 0 && join(head, rays, origin, length)) return lower_key(head, key);
    const std::int32_t place = take_place();
    Window& added = at(place);
    // One by one: a copy in one piece would have to wait until the pieces have reached the cache.
    added.rays.begin = rays.begin;
    added.rays.end = rays.end;
    added.rays.x = rays.x;
    added.rays.depth = rays.depth;
    added.offset = origin.offset;
    added.generator = origin.generator;
    added.crossed = origin.crossed;
    added.cycle_check_face = origin.cycle_check_face;
    added.joins = origin.joins;
    added.key = static_cast<float>(key * key_unit_);
    if (head < 0) {
      added.next = -1;
      head = place;
      return true;
    }
    Window& first = at(head);
    added.next = first.next;
    first.next = place;
    return lower_key(head, key);
  }

  /// Get the list of halfedge h, and the first window in it, into the cache.
  void prefetch_list(std::int32_t h) const { prefetch(first_ + h); }
  void prefetch_windows(std::int32_t h) const {
    if (first_[h] >= 0) prefetch(&at(first_[h]));
  }

  /// Removes the windows of halfedge h and calls visit(const Rays&, const Origin&) for each; `visit` may add windows to
  /// other halfedges.
  template <class Visit>
  void take(std::int32_t h, Visit visit) {
    std::int32_t place = first_[h];
    first_[h] = -1;
    while (place >= 0) {
      Window& w = at(place);
      const Rays rays = w.rays;
      const Origin origin{w.offset, w.generator, w.crossed, w.cycle_check_face, w.joins};
      const std::int32_t next = w.next;
      if (next >= 0) prefetch(&at(next));
      w.next = free_;
      free_ = place;
      visit(rays, origin);
      place = next;
    }
  }

  /// Gives the memory back. No window may wait.
  void release() {
    blocks_ = std::vector<std::unique_ptr<Window[]>>();
    used_ = 0;
    free_ = -1;
  }

 private:
  struct alignas(64) Window {
    Rays rays;
    double offset;
    std::int32_t generator;
    std::int32_t next;  // in the list, or -1
    float key;          // in the first window of a list: that of the halfedge in the queue, times key_unit_
    std::int32_t crossed;
    std::int32_t cycle_check_face;
    std::uint8_t joins;
  };
  static_assert(sizeof(Window) == 64);

  static constexpr int kShift = 8;
  static constexpr std::int32_t kMask = (1 << kShift) - 1;
  /// Ends that lie within this part of the edge are one.
  static constexpr double kSameEnd = 1e-9;

  const Window& at(std::int32_t i) const { return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask]; }
  Window& at(std::int32_t i) { return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask]; }

  std::int32_t take_place() {
    if (free_ >= 0) {
      const std::int32_t place = free_;
      free_ = at(place).next;
      return place;
    }
    if ((used_ & kMask) == 0) add_block();
    return used_++;
  }

  void add_block() {
    check_window_count(static_cast<std::size_t>(used_), kMask + 1);
    blocks_.push_back(std::make_unique_for_overwrite<Window[]>(kMask + 1));
  }

  bool lower_key(std::int32_t head, double key) {
    float& queued = at(head).key;
    if (!((key + key_step_) * key_unit_ < static_cast<double>(queued))) return false;
    queued = static_cast<float>(key * key_unit_);
    return true;
  }

  /// Makes one window of this and one that waits, if they are two neighbouring parts of one: they were split at a flat
  /// vertex, and see the same image again behind it. Nothing is lost.
  bool join(std::int32_t head, const Rays& rays, const Origin& origin, double length) {
    const double tolerance = kSameImage * (origin.offset + rays.depth + std::abs(rays.x));
    for (std::int32_t i = head; i >= 0; i = at(i).next) {
      Window& w = at(i);
      if (w.generator != origin.generator || w.offset != origin.offset) continue;
      if (std::abs(w.rays.x - rays.x) > tolerance || std::abs(w.rays.depth - rays.depth) > tolerance) continue;
      const int open = w.joins & ((origin.joins >> 1) | (origin.joins << 1));  // at its begin, where our end may join
      if ((open & Origin::kAtEnd) && std::abs(w.rays.end - rays.begin) <= kSameEnd * length) {
        unite(w, rays, origin);
        w.joins = static_cast<std::uint8_t>((w.joins & Origin::kAtBegin) | (origin.joins & Origin::kAtEnd));
        return true;
      }
      if ((open & Origin::kAtBegin) && std::abs(w.rays.begin - rays.end) <= kSameEnd * length) {
        unite(w, rays, origin);
        w.joins = static_cast<std::uint8_t>((w.joins & Origin::kAtEnd) | (origin.joins & Origin::kAtBegin));
        return true;
      }
    }
    return false;
  }

  /// The parts can be narrower than kSameEnd, so that which of them comes first can't be told from the ends that meet.
  /// Their paths went through different faces: what only some of them have crossed is forgotten.
  static void unite(Window& w, const Rays& rays, const Origin& origin) {
    w.rays.begin = std::min(w.rays.begin, rays.begin);
    w.rays.end = std::max(w.rays.end, rays.end);
    if (w.cycle_check_face != origin.cycle_check_face) w.cycle_check_face = -1;
    w.crossed = std::min(w.crossed, origin.crossed);
  }

  std::int32_t* first_;  // [halfedge] or -1
  std::vector<std::unique_ptr<Window[]>> blocks_;
  std::int32_t used_ = 0, free_ = -1;
  double key_step_;
  double key_unit_;  // a power of two that brings the step near 1, so that keys neither vanish nor overflow as floats
};

}  // namespace gvd
