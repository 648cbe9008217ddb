#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// A path to a point of a cell, as the energy's slope at the generator sees it.
struct PathSample {
  GeneratorId generator;
  float angle;    ///< tangent angle in which the path departs, radians
  double weight;  ///< distance times the mass that the point stands for, mesh units cubed: a float may overflow
};

/// Sorts samples by their generators, and keeps the order of those with the same generator. Cost: O(k log k).
inline void sort_by_generator(std::vector<PathSample>& samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const PathSample& a, const PathSample& b) { return a.generator < b.generator; });
}

/// The samples of generator g among sorted ones. Cost: O(log k), and O(1) for each of them.
inline std::span<const PathSample> samples_of(const std::vector<PathSample>& sorted, GeneratorId g) {
  const auto begin = std::lower_bound(sorted.begin(), sorted.end(), g,
                                      [](const PathSample& s, GeneratorId other) { return s.generator < other; });
  const auto end = std::find_if(begin, sorted.end(), [&](const PathSample& s) { return s.generator != g; });
  return {begin, end};
}

}  // namespace gvd
