#include "diagram/envelope/erase_loops.hpp"

#include <algorithm>

#include "base/barycentric.hpp"
#include "base/plane.hpp"

namespace gvd {
namespace {

/// Most points of a polyline for which O(n^2) is cheap. A longer one is the work of rounding, with a loop at every
/// other point.
constexpr std::size_t kMostPoints = 1000;

PlaneSegment segment(const Bary& from, const Bary& to) { return {affine_point(from), affine_point(to)}; }

/// The intersection of two segments; the second one's beginning where they are collinear.
Bary intersection_point(const Bary& from, const Bary& to, const Bary& begin, const Bary& end) {
  const PlaneSegment s = segment(from, to), o = segment(begin, end);
  const double t = intersect_lines(s.from, s.to - s.from, o.from, o.to - o.from).t;
  return t > 0 && t < 1 ? mix(begin, end, t) : begin;
}

/// Erases the loops found in one pass along the polyline. False where there are none.
bool erase_once(std::vector<Bary>& polyline) {
  const std::size_t n = polyline.size();
  std::vector<Bary> kept{polyline.front()};
  for (std::size_t i = 1; i < n; ++i) {
    const Bary from = kept.back(), to = polyline[i];
    std::size_t last = n;  // beginning of the last segment that intersects the one to point i
    for (std::size_t j = i + 1; j + 1 < n; ++j) {
      if (may_intersect(segment(from, to), segment(polyline[j], polyline[j + 1]))) last = j;
    }
    if (last == n) {
      kept.push_back(to);
    } else {
      kept.push_back(intersection_point(from, to, polyline[last], polyline[last + 1]));
      i = last;  // continue with the end of that segment
    }
  }
  const bool erased = kept.size() < n;
  polyline = std::move(kept);
  return erased;
}

}  // namespace

bool erase_loops(std::vector<Bary>& polyline) {
  if (polyline.size() > kMostPoints || !erase_once(polyline)) return false;
  while (erase_once(polyline)) {
    // Rounded intersections may form new loops. Every pass leaves fewer points, so this ends.
  }
  return true;
}

}  // namespace gvd
