#pragma once

#include <cstddef>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// The bounding boxes of a polygon's corners, of pairs of neighbours, of pairs of those, and so on: a corner in a
/// region is found without a look at those that are far from it.
class CornerBoxes {
 public:
  struct Box {
    Vec2 low;
    Vec2 high;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Cost: O(n).
  explicit CornerBoxes(const std::vector<Vec2>& corners);

  /// Cost: O(log n).
  void remove(std::size_t corner);

  /// The first corner from `from` on that is not removed and whose box, which is a point, is met; kNone where there is
  /// none. `meets` may say false of a box only if it does so of every corner in it.
  /// Cost: O(boxes that are met), O(n) at most.
  template <class Meets>
  std::size_t find(std::size_t from, const Meets& meets) const {
    return find_below(1, 0, leaves_, from, meets);
  }

 private:
  static Box empty_box();
  static bool is_empty(const Box& box) { return box.low.x() > box.high.x(); }
  void unite_children(std::size_t node);

  /// Among the corners first to last, which are those of `node`.
  template <class Meets>
  std::size_t find_below(std::size_t node, std::size_t first, std::size_t last, std::size_t from,
                         const Meets& meets) const {
    if (last <= from || is_empty(boxes_[node]) || !meets(boxes_[node])) return kNone;
    if (node >= leaves_) return first;
    const std::size_t middle = (first + last) / 2;
    const std::size_t found = find_below(2 * node, first, middle, from, meets);
    return found != kNone ? found : find_below(2 * node + 1, middle, last, from, meets);
  }

  std::size_t leaves_;      ///< a power of two, at least the number of corners
  std::vector<Box> boxes_;  ///< the children of box i are 2 i and 2 i + 1; the corners' own from leaves_ on
};

}  // namespace gvd
