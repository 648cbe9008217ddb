#include "diagram/envelope/arc_intersections.hpp"

#include <algorithm>

namespace gvd {

const std::vector<ArcIntersections::Pair>& ArcIntersections::find(const std::vector<ArcSegment>& segments) {
  found_.clear();
  if (segments.empty()) return found_;
  boxes_.build(segments.size(),
               [&](std::size_t i) { return bounding_box(segments[i].line.from, segments[i].line.to); });
  boxes_.visit_overlaps([&](std::size_t i, std::size_t j) {
    const ArcSegment &s = segments[i], &o = segments[j];
    if (may_intersect(s.line, o.line)) found_.emplace_back(std::min(s.arc, o.arc), std::max(s.arc, o.arc));
  });
  std::sort(found_.begin(), found_.end());
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  return found_;
}

}  // namespace gvd
