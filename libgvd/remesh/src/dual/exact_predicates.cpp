// Signs of determinants of coordinate differences.
//
// A filter in doubles decides nearly all signs. If its error bound leaves a sign open, the determinant is summed
// without rounding. So no test depends on a tolerance, and the answers never contradict each other. Source: J.
// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997: Two-Sum,
// Grow-Expansion with zero elimination, and the error bounds of the filters.
#include "dual/exact_predicates.hpp"

#include <algorithm>
#include <cmath>

#include "base/plane.hpp"

namespace gvd {
namespace {

/// a + b as the rounded sum and its error (Two-Sum).
std::array<double, 2> exact_sum(double a, double b) {
  const double sum = a + b, second = sum - a, first = sum - second;
  return {sum, (a - first) + (b - second)};
}

/// a b as the rounded product and its error.
std::array<double, 2> exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// Bound on the rounding error of a determinant of three differences, relative to its permanent: (7 + 56 e) e for the
/// rounding unit e = 2^-53, rounded up. Dimensionless. Source: Shewchuk 1997, bound A of ORIENT3D.
constexpr double kDeterminantError = 7.8e-16;

std::array<std::array<double, 2>, 3> exact_differences(const Vec3& to, const Vec3& from) {
  return {exact_difference(to.x(), from.x()), exact_difference(to.y(), from.y()), exact_difference(to.z(), from.z())};
}

int exact_determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto u = exact_differences(b, a), v = exact_differences(c, a), w = exact_differences(d, a);
  Expansion sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(u[j], v[k], w[i]);
    sum.add_product(negated(u[k]), v[j], w[i]);
  }
  return sum.sign();
}

}  // namespace

std::array<double, 2> exact_difference(double a, double b) { return exact_sum(a, -b); }

void Expansion::add(double value) {
  if (value == 0) return;
  double carry = value;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const auto [sum, error] = exact_sum(carry, components_[i]);
    if (error != 0) components_[kept++] = error;
    carry = sum;
  }
  components_.resize(kept);
  if (carry != 0) components_.push_back(carry);
}

// Coordinates that were floats or have few digits have differences without an error, so that most factors are 0.
void Expansion::add_product(const std::array<double, 2>& a, const std::array<double, 2>& b,
                            const std::array<double, 2>& c) {
  for (const double x : a) {
    for (const double y : b) {
      if (x == 0 || y == 0) continue;
      for (const double xy : exact_product(x, y)) {
        for (const double z : c) {
          if (xy == 0 || z == 0) continue;
          for (const double part : exact_product(xy, z)) add(part);
        }
      }
    }
  }
}

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (const int certain = orientation(a, b, c)) return certain;
  // The triangle is the base of a tetrahedron of height 1.
  const auto lifted = [](const Vec2& p, double height) { return Vec3(p.x(), p.y(), height); };
  return exact_determinant(lifted(a, 0), lifted(b, 0), lifted(c, 0), lifted(a, 1));
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  double determinant = 0, permanent = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = u[j] * v[k], right = u[k] * v[j];
    determinant += (left - right) * w[i];
    permanent += (std::abs(left) + std::abs(right)) * std::abs(w[i]);
  }
  if (std::abs(determinant) > kDeterminantError * permanent) return determinant > 0 ? 1 : -1;
  return exact_determinant(a, b, c, d);
}

}  // namespace gvd
