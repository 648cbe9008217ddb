#include "integrals/vertex_slope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/plane.hpp"

namespace gvd {
namespace {

using std::numbers::pi;

/// Directions in which the slope is tried first. No two of its minima are nearer to each other than a face is wide.
constexpr int kDirections = 64;

/// Steps of the golden-section search that follows: it ends with 1e-7 of the distance between two directions.
constexpr int kSearchSteps = 34;

}  // namespace

VertexSlope::VertexSlope(double total, bool is_closed, std::vector<VertexPath> paths)
    : total_(total), is_closed_(is_closed) {
  std::stable_sort(paths.begin(), paths.end(),
                   [](const VertexPath& a, const VertexPath& b) { return a.angle < b.angle; });
  sums_.push_back({});
  for (const VertexPath& path : paths) {
    angles_.push_back(path.angle);
    sums_.push_back({sums_.back().vector + path.weight * unit_vector(path.angle), sums_.back().weight + path.weight});
  }
}

VertexSlope::Sum VertexSlope::between(double begin, double end) const {
  const auto index = [&](double angle) {
    return static_cast<std::size_t>(std::lower_bound(angles_.begin(), angles_.end(), angle) - angles_.begin());
  };
  const Sum &first = sums_[index(begin)], &last = sums_[std::max(index(begin), index(end))];
  return {last.vector - first.vector, last.weight - first.weight};
}

double VertexSlope::at(double angle) const {
  const double reach = is_closed_ ? std::min(pi, 0.5 * total_) : pi;
  double straight = 0, weight = 0;
  for (int turn = is_closed_ ? -1 : 0; turn <= (is_closed_ ? 1 : 0); ++turn) {
    // Paths at angle a are also at a + turn * total.
    const double shift = turn * total_;
    const Sum sum = between(angle - reach - shift, angle + reach - shift);
    straight += sum.vector.dot(unit_vector(angle - shift));
    weight += sum.weight;
  }
  const double bent = sums_.back().weight - weight;
  return -2 * (straight - bent);
}

VertexSlope::Least VertexSlope::least() const {
  const double step = total_ / kDirections;
  double best = 0, least = at(0);
  for (int k = 1; k <= kDirections; ++k) {
    const double slope = at(k * step);
    if (slope < least) std::tie(best, least) = std::pair(k * step, slope);
  }
  double begin = best - step, end = best + step;
  if (!is_closed_) std::tie(begin, end) = std::pair(std::max(0.0, begin), std::min(total_, end));
  constexpr double golden = 2 - std::numbers::phi;
  for (int k = 0; k < kSearchSteps; ++k) {
    const double p = begin + golden * (end - begin), q = end - golden * (end - begin);
    (at(p) < at(q) ? end : begin) = at(p) < at(q) ? q : p;
  }
  const double middle = 0.5 * (begin + end), slope = at(middle);
  return slope < least ? Least{middle, slope} : Least{best, least};
}

}  // namespace gvd
