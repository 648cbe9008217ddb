#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd::bench {

/// The median of one value or more; of an even number the mean of the two in the middle. Cost: O(n log n).
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace gvd::bench
