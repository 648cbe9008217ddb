#include "diagram/envelope/compare_sources.hpp"

#include <cmath>
#include <utility>

#include "base/quadratic.hpp"

namespace gvd {
namespace {

constexpr int kNewtonSteps = 4;

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

/// Whether a source that is farther than another one at both ends of an interval is farther all over it. Both distances
/// are convex: the one lies above its tangents at the ends, the other one below its chord. So this is so where the
/// tangents intersect above the chord.
bool is_farther_between(const EndPaths& paths, const EndPaths& others, double width) {
  const double first = paths.begin.slope(), last = paths.end.slope();
  if (!(last > first)) return true;
  const double intersection = (paths.begin.distance - paths.end.distance + last * width) / (last - first);
  const double chord = others.begin.distance + (others.end.distance - others.begin.distance) * (intersection / width);
  return paths.begin.distance + first * intersection > chord;
}

}  // namespace

Nearer compare_sources(const EdgeSource& first, const EdgeSource& second, double begin, double end) {
  const EndPaths a(first, begin, end), b(second, begin, end);
  const double at_begin = b.begin.distance - a.begin.distance, at_end = b.end.distance - a.end.distance;
  if (at_begin > 0 && at_end > 0 && is_farther_between(b, a, end - begin)) return Nearer::first;
  if (at_begin < 0 && at_end < 0 && is_farther_between(a, b, end - begin)) return Nearer::second;
  return Nearer::open;
}

// The roots of sqrt(A) = sqrt(B) + c with A - B = slope t + rest, squared twice. Roots of the squares alone do no harm:
// the same source is nearer on both sides of them.
std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit) {
  const double c = (first.offset - second.offset) * unit;
  const double first_x = first.x * unit, second_x = second.x * unit;
  const double first_depth = first.depth * unit, second_depth = second.depth * unit;
  const double slope = 2 * (first_x - second_x);
  const double rest =
      (second_x - first_x) * (second_x + first_x) + (second_depth - first_depth) * (second_depth + first_depth) - c * c;
  if (c == 0) return {slope != 0 ? -rest / slope / unit : -1, -1};
  const double square = (slope - 2 * c) * (slope + 2 * c), half = slope * rest + 4 * c * c * first_x;
  const double constant = rest * rest - 4 * c * c * (first_x * first_x + first_depth * first_depth);
  auto roots = quadratic_roots(square, half, constant);
  for (double& root : roots) root = std::isfinite(root) ? root / unit : -1;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return roots;
}

double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end,
                          double position) {
  double t = position, error = first.straight(t) - second.straight(t);
  for (int step = 0; step < kNewtonSteps && error != 0; ++step) {
    const double slope =
        (t - first.x) / (first.straight(t) - first.offset) - (t - second.x) / (second.straight(t) - second.offset);
    const double next = t - error / slope;
    if (!(next > begin && next < end)) break;
    const double after = first.straight(next) - second.straight(next);
    if (!(std::abs(after) < std::abs(error))) break;
    t = next;
    error = after;
  }
  return t;
}

}  // namespace gvd
