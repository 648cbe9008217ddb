#include "base/segment.hpp"

#include <algorithm>

#include "base/box.hpp"

namespace gvd {
namespace {

bool separates_beyond(const PlaneSegment& line, const PlaneSegment& other, double tolerance) {
  const double from = twice_signed_area(line.from, line.to, other.from);
  const double to = twice_signed_area(line.from, line.to, other.to);
  return std::min(from, to) < -tolerance && std::max(from, to) > tolerance;
}

}  // namespace

bool may_intersect(const PlaneSegment& a, const PlaneSegment& b) {
  if (!overlap(bounding_box(a.from, a.to), bounding_box(b.from, b.to))) return false;
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return false;
  return orientation(a.from, a.to, b.from) * orientation(a.from, a.to, b.to) <= 0 &&
         orientation(b.from, b.to, a.from) * orientation(b.from, b.to, a.to) <= 0;
}

bool intersect_beyond(const PlaneSegment& a, const PlaneSegment& b, double tolerance) {
  return separates_beyond(a, b, tolerance) && separates_beyond(b, a, tolerance);
}

}  // namespace gvd
