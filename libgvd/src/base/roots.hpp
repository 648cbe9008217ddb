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

/// An interval at whose begin a continuous function is negative, and at whose end it is positive.
struct SignChange {
  double begin, end;
  double at_begin, at_end;  ///< the function's values there, < 0 and > 0
};

/// A root of `function` in `bracket`: by the secant through the bracket's ends, and by halving in every third step, so
/// that it converges where the secant stagnates.
///
/// Returns: a root, or the middle of a bracket that is not wider than `width`.
/// Cost: at most 100 evaluations, which halve the bracket 33 times at least; 19 for x^2 - 2 in [0, 2] to 1e-14.
template <class Function>
double find_root(SignChange bracket, double width, const Function& function) {
  constexpr int kMostSteps = 100;
  auto& [begin, end, at_begin, at_end] = bracket;
  for (int step = 0; step < kMostSteps && end - begin > width; ++step) {
    double middle = begin - at_begin * (end - begin) / (at_end - at_begin);
    if (step % 3 == 2 || !(middle > begin && middle < end)) middle = 0.5 * (begin + end);
    const double value = function(middle);
    if (value == 0) return middle;
    (value < 0 ? begin : end) = middle;
    (value < 0 ? at_begin : at_end) = value;
  }
  return 0.5 * (begin + end);
}

/// The last number in [0, 1) that `holds` accepts, if it accepts 0 and all up to some number below 1: by `halvings`
/// halvings. Where it accepts several intervals, the end of one of them.
template <class Holds>
double find_last(int halvings, const Holds& holds) {
  double accepted = 0, refused = 1;
  for (int i = 0; i < halvings; ++i) {
    const double t = 0.5 * (accepted + refused);
    (holds(t) ? accepted : refused) = t;
  }
  return accepted;
}

}  // namespace gvd
