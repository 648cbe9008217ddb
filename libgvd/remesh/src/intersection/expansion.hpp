#pragma once

#include <array>
#include <vector>

namespace gvd {

/// A sum of doubles without rounding.
///
/// Source: J. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997:
/// Grow-Expansion with zero elimination. Exact unless a product underflows or overflows.
class Expansion {
 public:
  /// Cost: O(components), of which there are at most as many as calls.
  void add(double value);

  /// Adds a product of differences, each the sum of two doubles (see exact_difference).
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b);
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);

  /// -1, 0 or 1.
  int sign() const;

 private:
  std::vector<double> components_;  // not 0, no two overlap, ascending by magnitude
};

/// a - b as the sum of two doubles: the rounded difference and its error.
std::array<double, 2> exact_difference(double a, double b);

/// -x.
inline std::array<double, 2> negated(const std::array<double, 2>& x) { return {-x[0], -x[1]}; }

}  // namespace gvd
