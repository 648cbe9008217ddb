#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/box_tree.hpp"
#include "base/plane.hpp"

namespace gvd {

/// A straight piece of an arc, in any coordinates of its face.
struct ArcSegment {
  PlaneSegment line;
  std::int32_t arc;
};

/// Finds the arcs of a face that intersect. Using one object for many faces saves allocations.
class ArcIntersections {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// The pairs of arcs (also of an arc with itself) of which two segments may intersect elsewhere than at a common end.
  /// All other pairs are disjoint, except for segments of the same direction from a common end.
  /// `segments`: the arcs one after the other, each from its beginning to its end.
  /// Returns: ascending, each pair once; valid until the next call.
  /// Cost: O(n log n) for n segments of which few are near each other, by a tree of bounding boxes.
  const std::vector<Pair>& find(const std::vector<ArcSegment>& segments);

 private:
  BoxTree boxes_;  // of the segments
  std::vector<Pair> found_;
};

}  // namespace gvd
