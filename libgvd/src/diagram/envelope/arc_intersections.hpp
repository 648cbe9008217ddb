#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/box_tree.hpp"
#include "base/segment.hpp"

namespace gvd {

/// A straight piece of an arc, in any coordinates of its face.
struct ArcSegment {
  PlaneSegment line;
  std::int32_t arc;
};

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
  BoxTree boxes_;  // of the segments
  std::vector<Pair> found_;
};

}  // namespace gvd
