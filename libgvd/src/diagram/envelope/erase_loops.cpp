#include "diagram/envelope/erase_loops.hpp"

#include <algorithm>

#include "base/barycentric.hpp"
#include "base/segment.hpp"

namespace gvd {
namespace {

/// What O(n^2) is cheap for. So many points are the work of rounding, with a loop at every other one.
constexpr std::size_t kMostPoints = 1000;

PlaneSegment segment(const Bary& from, const Bary& to) { return {affine_point(from), affine_point(to)}; }

/// Where two segments that meet do so; the second one's begin, where they lie on one line.
Bary meeting_point(const Bary& from, const Bary& to, const Bary& begin, const Bary& end) {
  const PlaneSegment s = segment(from, to), o = segment(begin, end);
  const double t = intersect_lines(s.from, s.to - s.from, o.from, o.to - o.from).t;
  return t > 0 && t < 1 ? mix(begin, end, t) : begin;
}

/// Takes out the loops that it meets on its way. False where there are none.
bool erase_once(std::vector<Bary>& polyline) {
  const std::size_t n = polyline.size();
  std::vector<Bary> kept{polyline.front()};
  for (std::size_t i = 1; i < n; ++i) {
    const Bary from = kept.back(), to = polyline[i];
    std::size_t last = n;  // the farthest segment that the one to point i meets begins at this point
    for (std::size_t j = i + 1; j + 1 < n; ++j) {
      if (may_intersect(segment(from, to), segment(polyline[j], polyline[j + 1]))) last = j;
    }
    if (last == n) {
      kept.push_back(to);
    } else {
      kept.push_back(meeting_point(from, to, polyline[last], polyline[last + 1]));
      i = last;  // and on to the point after it
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
    // Rounding of the places where loops closed may leave others; there are fewer points each time.
  }
  return true;
}

}  // namespace gvd
