#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// A straight piece of an arc, in any coordinates of its face.
struct ArcSegment {
  Vec2 from, to;
  std::int32_t arc;
};

/// Whether two segments cross or touch elsewhere than where both end, or rounding leaves that open.
bool may_intersect(const ArcSegment& s, const ArcSegment& o);

/// Which arcs of a face meet. A face after the other is looked at with the same object, which saves allocations.
class ArcIntersections {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// The pairs of arcs (an arc with itself, too) of which two segments meet elsewhere than where both end: where they
  /// cross or touch, and where rounding leaves that open. What is not among them is disjoint, but
  /// for segments that go the same way from one end that they share.
  /// `segments`: one arc after the other, each from its beginning to its end. Ascending, each pair once; valid until
  /// the next call.
  /// Cost: O(n log n) for n segments where few come near each other, by a tree of bounding boxes.
  const std::vector<Pair>& find(const std::vector<ArcSegment>& segments);

 private:
  struct Box {
    Vec2 low, high;
  };

  void build(const std::vector<ArcSegment>& segments);
  void look_within(std::size_t node);
  void look_between(std::size_t node, std::size_t other);
  bool is_segment(std::size_t node) const { return node >= leaves_; }

  const std::vector<ArcSegment>* segments_ = nullptr;
  std::vector<Box> boxes_;  // of a binary tree: the children of node i are 2 i and 2 i + 1, its root is 1
  std::size_t leaves_ = 1;  // the first node that is a segment
  std::vector<Pair> found_;
};

}  // namespace gvd
