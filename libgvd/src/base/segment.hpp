#pragma once

#include "base/plane.hpp"

namespace gvd {

/// A straight line segment in the plane.
struct PlaneSegment {
  Vec2 from, to;
};

/// The parameters of the point p + s d = q + t e.
struct LineIntersection {
  double s, t;
};

/// Where the line through p along d crosses the line through q along e. Not finite where the lines are parallel.
inline LineIntersection intersect_lines(const Vec2& p, const Vec2& d, const Vec2& q, const Vec2& e) {
  const Vec2 between = q - p;
  const double denominator = cross(d, e);
  return {cross(between, e) / denominator, cross(between, d) / denominator};
}

// Three predicates tell whether segments cross. They differ in what they answer where rounding leaves it open.

/// Whether two segments cross or touch elsewhere than at a common end, or rounding leaves that open. For a search that
/// must not miss a crossing. Never false of segments that cross.
bool may_intersect(const PlaneSegment& a, const PlaneSegment& b);

/// Whether two segments cross by more than `tolerance`: the ends of each lie on both sides of the other's line, and
/// both triangles that they form with it have more than this twice the area. For a check that must not fail by
/// rounding.
bool intersect_beyond(const PlaneSegment& a, const PlaneSegment& b, double tolerance);

/// Whether p and q lie strictly on one side of the segment's line, as rounded.
inline bool lie_on_one_side(const PlaneSegment& line, const Vec2& p, const Vec2& q) {
  return twice_signed_area(line.from, line.to, p) * twice_signed_area(line.from, line.to, q) > 0;
}

}  // namespace gvd
