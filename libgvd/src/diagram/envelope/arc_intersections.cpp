#include "diagram/envelope/arc_intersections.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace gvd {
namespace {

/// Bound on the rounding of an orientation, as a part of its two products: (3 + 16 e) e for the rounding unit e (J.
/// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997).
constexpr double kOrientationError = 3.4e-16;

/// On which side of the line from a to b point c lies: 1 on the left, -1 on the right, 0 where rounding leaves it open.
int side_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double area = left - right;
  if (std::abs(area) <= kOrientationError * (std::abs(left) + std::abs(right))) return 0;
  return area > 0 ? 1 : -1;
}

bool overlap(const Vec2& low, const Vec2& high, const Vec2& other_low, const Vec2& other_high) {
  return (low.array() <= other_high.array()).all() && (other_low.array() <= high.array()).all();
}

}  // namespace

bool may_intersect(const ArcSegment& s, const ArcSegment& o) {
  if (!overlap(s.from.cwiseMin(s.to), s.from.cwiseMax(s.to), o.from.cwiseMin(o.to), o.from.cwiseMax(o.to)))
    return false;
  if (s.from == o.from || s.from == o.to || s.to == o.from || s.to == o.to) return false;
  return side_of(s.from, s.to, o.from) * side_of(s.from, s.to, o.to) <= 0 &&
         side_of(o.from, o.to, s.from) * side_of(o.from, o.to, s.to) <= 0;
}

const std::vector<ArcIntersections::Pair>& ArcIntersections::find(const std::vector<ArcSegment>& segments) {
  found_.clear();
  if (segments.empty()) return found_;
  build(segments);
  look_within(1);
  std::sort(found_.begin(), found_.end());
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  return found_;
}

void ArcIntersections::build(const std::vector<ArcSegment>& segments) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  segments_ = &segments;
  leaves_ = std::bit_ceil(segments.size());
  boxes_.assign(2 * leaves_, {Vec2(kInfinity, kInfinity), Vec2(-kInfinity, -kInfinity)});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ArcSegment& s = segments[i];
    boxes_[leaves_ + i] = {s.from.cwiseMin(s.to), s.from.cwiseMax(s.to)};
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    const Box &first = boxes_[2 * node], &second = boxes_[2 * node + 1];
    boxes_[node] = {first.low.cwiseMin(second.low), first.high.cwiseMax(second.high)};
  }
}

void ArcIntersections::look_within(std::size_t node) {
  if (is_segment(node)) return;
  look_within(2 * node);
  look_within(2 * node + 1);
  look_between(2 * node, 2 * node + 1);
}

/// Both nodes are of one level of the tree.
void ArcIntersections::look_between(std::size_t node, std::size_t other) {
  const Box &box = boxes_[node], &second = boxes_[other];
  if (!overlap(box.low, box.high, second.low, second.high)) return;
  if (is_segment(node)) {
    const ArcSegment &s = (*segments_)[node - leaves_], &o = (*segments_)[other - leaves_];
    if (may_intersect(s, o)) found_.emplace_back(std::min(s.arc, o.arc), std::max(s.arc, o.arc));
    return;
  }
  for (const std::size_t child : {2 * node, 2 * node + 1}) {
    look_between(child, 2 * other);
    look_between(child, 2 * other + 1);
  }
}

}  // namespace gvd
