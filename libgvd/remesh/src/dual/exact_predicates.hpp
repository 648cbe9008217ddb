#pragma once

#include <array>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// A sum of doubles without rounding. Exact unless a product underflows or overflows.
class Expansion {
 public:
  /// Cost: O(components). There are at most as many components as there were calls.
  void add(double value);

  /// Adds a product of differences, each the sum of two doubles (see exact_difference).
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);

  /// -1, 0 or 1.
  int sign() const {
    if (components_.empty()) return 0;
    return components_.back() > 0 ? 1 : -1;
  }

 private:
  std::vector<double> components_;  // not 0, no two overlap, ascending by magnitude
};

/// a - b as the sum of two doubles: the rounded difference and its error.
std::array<double, 2> exact_difference(double a, double b);

inline std::array<double, 2> negated(const std::array<double, 2>& x) { return {-x[0], -x[1]}; }

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 on the line. Exact.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The side of the plane through a, b and c on which d lies. 1: a, b and c appear counter-clockwise from d; -1: the
/// other side; 0: in the plane, or a, b and c lie on a line. Exact, unless a product underflows.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace gvd
