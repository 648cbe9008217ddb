#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace gvd {

/// Area of a polygon given in barycentric coordinates, as a part of its face's area; < 0 where it goes round clockwise.
inline double area_share(const std::vector<std::array<double, 3>>& polygon) {
  double twice = 0;
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % n];
    twice += p[1] * q[2] - p[2] * q[1];
  }
  return twice;
}

}  // namespace gvd
