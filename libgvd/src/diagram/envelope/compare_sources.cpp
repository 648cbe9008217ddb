#include "diagram/envelope/compare_sources.hpp"

#include <cmath>
#include <utility>

#include "base/roots.hpp"

namespace gvd {
namespace {

constexpr int kPolishSteps = 4;

}  // namespace

std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit) {
  // The roots of sqrt(B) = sqrt(A) + c, with B - A - c^2 = slope t + rest, squared twice. Roots of the squares alone do
  // no harm: the same source is nearer on both sides of them. Positions count from the foot of the first image: where
  // both images are much nearer to each other than to the start of the edge, its squares would hide where they differ.
  const double c = (first.offset - second.offset) * unit, apart = (second.x - first.x) * unit;
  const double first_depth = first.depth * unit, second_depth = second.depth * unit;
  const double slope = -2 * apart;
  const double rest = apart * apart + (second_depth - first_depth) * (second_depth + first_depth) - c * c;
  if (c == 0) return {slope != 0 ? first.x - rest / slope / unit : -1, -1};
  // With different feet, positions count from where slope t + rest is 0. There is one root on either side, and nothing
  // cancels, even if they are very near: two sources that tie at an end of the edge, but for their symbolic offsets.
  const bool has_centre = std::abs(slope) > 2 * std::abs(c);
  const double centre = has_centre ? -rest / slope : 0, far = centre * centre + first_depth * first_depth;
  const double square = (slope - 2 * c) * (slope + 2 * c), half = has_centre ? -4 * c * c * centre : slope * rest;
  const double constant = has_centre ? -4 * c * c * far : (rest - 2 * c * first_depth) * (rest + 2 * c * first_depth);
  auto roots = quadratic_roots(square, half, constant);
  for (double& root : roots) root = std::isfinite(root) ? first.x + (centre + root) / unit : -1;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return roots;
}

double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end,
                          double position) {
  double t = position, error = first.straight(t) - second.straight(t);
  for (int step = 0; step < kPolishSteps && error != 0; ++step) {
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
