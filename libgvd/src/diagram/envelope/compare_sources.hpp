#pragma once

#include <array>
#include <cmath>

#include "geodesic/distance_field.hpp"

namespace gvd {
namespace edge_source_detail {

/// The straight path from a source to a point of the edge.
struct StraightPath {
  double along, straight, distance;
  StraightPath(const EdgeSource& s, double t)
      : along(t - s.x), straight(std::sqrt(along * along + s.depth * s.depth)), distance(s.offset + straight) {}
  /// Derivative of the distance along the edge.
  double slope() const { return straight > 0 ? along / straight : 0; }
};

/// A source's straight paths to the two ends of an interval.
struct EndPaths {
  StraightPath begin, end;
  EndPaths(const EdgeSource& s, double from, double to) : begin(s, from), end(s, to) {}
};

/// Whether a source that is farther than another one at both ends of an interval is farther everywhere in it. Both
/// distances are convex: the one lies above its tangents at the ends, the other one below its chord. So the answer is
/// yes if the tangents intersect above the chord.
inline bool is_farther_between(const EndPaths& paths, const EndPaths& others, double width) {
  const double first = paths.begin.slope(), last = paths.end.slope();
  if (!(last > first)) return true;
  const double intersection = (paths.begin.distance - paths.end.distance + last * width) / (last - first);
  const double chord = others.begin.distance + (others.end.distance - others.begin.distance) * (intersection / width);
  return paths.begin.distance + first * intersection > chord;
}

}  // namespace edge_source_detail

/// Which of two sources of an edge is nearer on an interval, by their straight paths.
enum class Nearer { first, second, open };

/// Compares two sources on [begin, end]. `open`: the nearer one may change in the interval.
/// Cost: O(1). Inline: in the innermost loop of the envelope a call would cost as much as the comparison.
inline Nearer compare_sources(const EdgeSource& first, const EdgeSource& second, double begin, double end) {
  const edge_source_detail::EndPaths a(first, begin, end), b(second, begin, end);
  const double at_begin = b.begin.distance - a.begin.distance, at_end = b.end.distance - a.end.distance;
  if (at_begin > 0 && at_end > 0 && edge_source_detail::is_farther_between(b, a, end - begin)) return Nearer::first;
  if (at_begin < 0 && at_end < 0 && edge_source_detail::is_farther_between(a, b, end - begin)) return Nearer::second;
  return Nearer::open;
}

/// The positions on the edge's line where the straight paths of two sources may be equally long, ascending; -1 in place
/// of one that does not exist. They include all such positions, to half of the digits where the two distances touch.
/// Some are none.
/// `unit`: a power of two that brings the edge's length near 1, so that sixth powers of it stay in range.
std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit);

/// Improves such a position by Newton's steps, inside of (begin, end).
double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end, double position);

}  // namespace gvd
