#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Image of a point source at distances d_a from a and d_b from b, on the right of a -> b: outside of a triangle on the
/// left. Where the distances break the triangle inequality, the image lies on the line through a and b.
/// Inputs: mesh units, distances >= 0, a and b different. Cost: O(1).
inline Vec2 unfold_source(const Vec2& a, const Vec2& b, double d_a, double d_b) {
  const Vec2 along = b - a;
  const double length = along.norm();
  const double x = apex_foot(length, d_a, d_b);
  const double depth = std::sqrt(std::max(0.0, (d_a - x) * (d_a + x)));
  const Vec2 unit = along / length;
  return a + x * unit - depth * turned_left(unit);
}

/// Image of a generator in the plane of a triangle, from its distances to the three corners. It is unfolded over the
/// side through which its front enters: the one with the smallest sum of distances.
inline Vec2 unfold_generator(const std::array<Vec2, 3>& corner, const std::array<double, 3>& distance) {
  std::size_t side = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (distance[i] + distance[(i + 1) % 3] < distance[side] + distance[(side + 1) % 3]) side = i;
  }
  return unfold_source(corner[side], corner[(side + 1) % 3], distance[side], distance[(side + 1) % 3]);
}

/// Parameter t of the point a + t (b - a) that is equally far from p and q; -1 if there is none or every point is.
/// Cost: O(1).
inline double equidistant_parameter(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  const Vec2 normal = q - p;
  const double along = normal.dot(b - a);
  const double to_middle = normal.dot(0.5 * (p + q) - a);
  return along == 0 ? -1 : to_middle / along;
}

}  // namespace gvd
