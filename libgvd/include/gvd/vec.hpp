#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

namespace gvd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The distance of points that no generator reaches, and the initial value of every search for a least value.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The parameter of the foot of p on the line through a and b: 0 at a, 1 at b. It is not limited to [0, 1], and not
/// finite if a equals b. `Vec` is Vec2 or Vec3.
template <class Vec>
double foot_on_line(const Vec& a, const Vec& b, const Vec& p) {
  const Vec along = b - a;
  return along.dot(p - a) / along.squaredNorm();
}

}  // namespace gvd
