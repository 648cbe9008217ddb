#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace gvd {

/// The two roots of a x^2 + 2 half_b x + c = 0, without cancellation, in no particular order.
///
/// A negative discriminant counts as 0: callers know that the roots are real, and rounding can make the discriminant of
/// a double root negative. Where a root does not exist, its value is infinite or not a number.
inline std::array<double, 2> quadratic_roots(double a, double half_b, double c) {
  const double root = std::sqrt(std::max(0.0, half_b * half_b - a * c));
  const double q = -(half_b + std::copysign(root, half_b));
  return {q / a, c / q};
}

}  // namespace gvd
