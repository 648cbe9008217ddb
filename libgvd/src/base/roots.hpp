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

/// An interval over which a continuous function changes its sign: it is negative at the beginning and positive at the
/// end.
struct SignChange {
  double begin, end;
  double at_begin, at_end;  ///< the function's values there, < 0 and > 0
};

/// Finds a root of `function` in `bracket`. Steps use the secant through the ends of the bracket; every third step
/// halves it instead, so that the search converges even where the secant stagnates.
///
/// Returns: a point where the function is 0, or the middle of the last bracket, which is not wider than `width` unless
/// 100 evaluations were not enough.
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

/// Finds the end of an interval of numbers that begins at 0 and that `holds` accepts, by bisection of [0, 1]: returns
/// the last accepted number of `halvings` steps, or 0. If `holds` accepts several intervals, this is near the end of
/// one of them.
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
