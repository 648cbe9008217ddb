#include "diagram/assembly/find_pairs_to_unite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace gvd {
namespace {

/// How much farther the generator of interval i is at p than the nearest other one of the polygon.
double excess_at(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, const Bary& p) {
  double others = std::numeric_limits<double>::infinity();
  for (const PolygonCorner& c : polygon) {
    if (c.next != polygon[i].next) others = std::min(others, distances.at(c.next, p));
  }
  const double own = distances.at(polygon[i].next, p);
  return std::isinf(own) ? own : own - others;
}

/// Segments between two intervals of a polygon with at most so many are tried. Two cells whose four intervals alternate
/// are the usual case. More intervals would cost the square of their number.
constexpr std::size_t kFewIntervals = 6;

/// Where these segments begin and end on their intervals, as fractions.
constexpr std::array<double, 5> kEnds{0.5, 0.1, 0.9, 0.3, 0.7};

/// Samples of a segment, in the order of multiples of the golden ratio: any number of them is spread evenly. A channel
/// of the other cell across the segment is found if it is wider than a thirtieth of it.
constexpr int kSamples = 48;
constexpr double kGoldenRatio = 0.61803398874989484;

/// The largest excess along the best of some segments between intervals i and j: below 0 where the segment stays in the
/// cell, so that they belong to one piece.
double excess_along_segments(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, std::size_t j) {
  const auto point = [&](std::size_t k, double t) {
    return mix(polygon[k].bary, polygon[(k + 1) % polygon.size()].bary, t);
  };
  double least = std::numeric_limits<double>::infinity();
  for (const double begin : kEnds) {
    for (const double end : kEnds) {
      double most = -std::numeric_limits<double>::infinity();
      double t = 0.5;
      for (int k = 0; k < kSamples && most < least; ++k, t = std::fmod(t + kGoldenRatio, 1)) {
        most = std::max(most, excess_at(polygon, distances, i, mix(point(i, begin), point(j, end), t)));
      }
      least = std::min(least, most);
    }
  }
  return least;
}

double compute_excess(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, std::size_t j) {
  if (distances.can_confirm() && polygon.size() <= kFewIntervals) {
    return excess_along_segments(polygon, distances, i, j);
  }
  return excess_at(polygon, distances, i, mix(midpoint(polygon, i), midpoint(polygon, j), 0.5));
}

/// All pairs of one generator, ascending by excess, then by corners.
std::vector<IntervalPair> collect_pairs(const FacePolygon& polygon, const FaceDistances& distances) {
  std::map<GeneratorId, std::vector<std::size_t>> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i) corners[polygon[i].next].push_back(i);
  std::vector<IntervalPair> pairs;
  for (const auto& [generator, own] : corners) {
    for (std::size_t b = 1; b < own.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a)
        pairs.push_back({compute_excess(polygon, distances, own[a], own[b]), own[a], own[b]});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const IntervalPair& a, const IntervalPair& b) {
    return std::tie(a.excess, a.i, a.j) < std::tie(b.excess, b.i, b.j);
  });
  return pairs;
}

bool has_three_different(const FacePolygon& polygon) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (polygon[i].next != polygon[(i + 2) % n].next) return true;
  }
  return false;
}

}  // namespace

bool IntervalPair::crosses(const IntervalPair& other) const {
  const auto is_between = [this](std::size_t k) { return i < k && k < j; };
  const auto is_end = [this](std::size_t k) { return i == k || j == k; };
  return is_between(other.i) != is_between(other.j) && !is_end(other.i) && !is_end(other.j);
}

std::vector<IntervalPair> find_pairs_to_unite(const FacePolygon& polygon, const FaceDistances& distances) {
  const std::vector<IntervalPair> pairs = collect_pairs(polygon, distances);
  std::vector<IntervalPair> chosen;
  for (const IntervalPair& pair : pairs) {
    const bool fits =
        std::none_of(chosen.begin(), chosen.end(), [&](const IntervalPair& c) { return c.crosses(pair); });
    if (pair.excess <= 0 && fits) chosen.push_back(pair);
  }
  // Distances that can confirm have found no branch point here. So two intervals of one cell belong to one piece,
  // though their paths enter through different sides.
  const bool must_unite = distances.can_confirm() || !has_three_different(polygon);
  if (chosen.empty() && !pairs.empty() && must_unite) chosen.push_back(pairs.front());
  return chosen;
}

}  // namespace gvd
