#pragma once

#include <cmath>
#include <cstddef>

#include "gvd/vec.hpp"

namespace gvd {

/// Cross product in the plane: > 0 where b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v, rotated counter-clockwise by 90 degrees.
inline Vec2 turned_left(const Vec2& v) { return {-v.y(), v.x()}; }

/// The vector of length 1 at this angle from the x axis, radians.
inline Vec2 unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Twice the signed area of a triangle: > 0 where a, b, c are counter-clockwise. Subject to rounding; `orientation`
/// gives the sign where it is certain.
inline double twice_signed_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

/// Twice the signed area of a polygon of n corners (the shoelace formula). `corner(i)` is a Vec2.
template <class Corner>
double twice_signed_area(std::size_t n, const Corner& corner) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += cross(corner(i), corner((i + 1) % n));
  return sum;
}

/// Bound on the rounding error of an orientation, relative to the sum of its two products: (3 + 16 e) e for the
/// rounding unit e = 2^-53, rounded up. Dimensionless.
inline constexpr double kOrientationError = 3.4e-16;

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 where rounding leaves it open.
///
/// Source: the filter of J. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
/// 1997. A result other than 0 is exact, unless a product underflows.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double area = left - right;
  if (std::abs(area) <= kOrientationError * (std::abs(left) + std::abs(right))) return 0;
  return area > 0 ? 1 : -1;
}

}  // namespace gvd
