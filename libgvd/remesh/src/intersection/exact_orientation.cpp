#include "intersection/exact_orientation.hpp"

#include <array>
#include <cmath>

#include "base/plane.hpp"
#include "intersection/expansion.hpp"

namespace gvd {
namespace {

/// Bound on the rounding error of a determinant of three differences, relative to its permanent: (7 + 56 e) e for the
/// rounding unit e = 2^-53, rounded up. Dimensionless. Source: Shewchuk 1997, bound A of ORIENT3D.
constexpr double kDeterminantError = 7.8e-16;

using Difference = std::array<double, 2>;

std::array<Difference, 3> exact_differences(const Vec3& to, const Vec3& from) {
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

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (const int certain = orientation(a, b, c)) return certain;
  Expansion sum;
  sum.add_product(exact_difference(b.x(), a.x()), exact_difference(c.y(), a.y()));
  sum.add_product(exact_difference(a.y(), b.y()), exact_difference(c.x(), a.x()));
  return sum.sign();
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
