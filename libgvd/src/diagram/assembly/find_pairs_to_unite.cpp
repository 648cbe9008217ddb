#include "diagram/assembly/find_pairs_to_unite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace gvd {
namespace {

double compute_excess(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, std::size_t j) {
  const auto between = mix(midpoint(polygon, i), midpoint(polygon, j), 0.5);
  double others = std::numeric_limits<double>::infinity();
  for (const PolygonCorner& c : polygon) {
    if (c.next != polygon[i].next) others = std::min(others, distances.at(c.next, between));
  }
  const double own = distances.at(polygon[i].next, between);
  return std::isinf(own) ? own : own - others;
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
