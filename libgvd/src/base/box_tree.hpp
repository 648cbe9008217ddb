#pragma once

#include <bit>
#include <cstddef>
#include <vector>

#include "base/plane.hpp"

namespace gvd {

/// A balanced binary tree over a list of boxes. Each node holds the box of its two children, so a search skips whole
/// ranges of the list. It pays off where neighbours in the list lie near each other, as the corners of a polygon do.
template <class Box>
class BoxTreeOf {
 public:
  static constexpr std::size_t kNone = -1;

  /// Builds the tree over items 0 .. n - 1, where `box_of(i)` is the box of item i. Any previous items are discarded.
  /// Cost: O(n).
  template <class BoxOf>
  void build(std::size_t n, const BoxOf& box_of) {
    leaves_ = std::bit_ceil(n);
    boxes_.assign(2 * leaves_, Box());
    for (std::size_t i = 0; i < n; ++i) boxes_[leaves_ + i] = box_of(i);
    for (std::size_t node = leaves_; node-- > 1;) unite_children(node);
  }

  /// Removes an item from all later searches. Cost: O(log n).
  void remove(std::size_t item) { move(item, Box()); }

  /// Gives an item another box. Cost: O(log n).
  void move(std::size_t item, const Box& box) {
    std::size_t node = leaves_ + item;
    boxes_[node] = box;
    while ((node /= 2) > 0) unite_children(node);
  }

  /// Returns the first item, from `from` on, that was not removed and whose box passes the test; kNone if there is
  /// none. If `test` rejects a box, it must reject every box inside it.
  /// Cost: O(nodes that pass the test), at most O(n).
  template <class Test>
  std::size_t find(std::size_t from, const Test& test) const {
    return leaves_ > 0 ? find_below(1, {0, leaves_, from}, test) : kNone;
  }

  /// Calls visit(i, j) for every pair of items i < j whose boxes overlap. Cost: O(n log n) where few overlap.
  template <class Visit>
  void visit_overlaps(const Visit& visit) const {
    if (leaves_ > 0) visit_within(1, visit);
  }

 private:
  /// Items first .. last - 1 lie below the current node; the search skips items before `from`.
  struct Range {
    std::size_t first, last, from;
  };

  void unite_children(std::size_t node) { boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]); }
  bool is_leaf(std::size_t node) const { return node >= leaves_; }

  template <class Test>
  std::size_t find_below(std::size_t node, const Range& range, const Test& test) const {
    if (range.last <= range.from || boxes_[node].isEmpty() || !test(boxes_[node])) return kNone;
    if (is_leaf(node)) return range.first;
    const std::size_t middle = (range.first + range.last) / 2;
    const std::size_t found = find_below(2 * node, {range.first, middle, range.from}, test);
    return found != kNone ? found : find_below(2 * node + 1, {middle, range.last, range.from}, test);
  }

  template <class Visit>
  void visit_within(std::size_t node, const Visit& visit) const {
    if (is_leaf(node)) return;
    visit_within(2 * node, visit);
    visit_within(2 * node + 1, visit);
    visit_between(2 * node, 2 * node + 1, visit);
  }

  /// Visits the overlapping pairs of an item below `left` and one below `right`, two different nodes of the same level
  /// in this order.
  template <class Visit>
  void visit_between(std::size_t left, std::size_t right, const Visit& visit) const {
    if (!boxes_[left].intersects(boxes_[right])) return;
    if (is_leaf(left)) return visit(left - leaves_, right - leaves_);
    for (const std::size_t child : {2 * left, 2 * left + 1}) {
      visit_between(child, 2 * right, visit);
      visit_between(child, 2 * right + 1, visit);
    }
  }

  std::size_t leaves_ = 0;  ///< a power of two, at least the number of items; 0 before build()
  std::vector<Box> boxes_;  ///< the root is 1, the children of node i are 2 i and 2 i + 1, item i is leaves_ + i
};

/// The tree of boxes in the plane.
using BoxTree = BoxTreeOf<Box2>;

}  // namespace gvd
