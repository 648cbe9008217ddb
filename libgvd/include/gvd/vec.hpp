#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

namespace gvd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The distance of points that no generator reaches, and the start of every search for a least value.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The foot of p on the line through a and b, as the share of the way from a to b: 0 at a, 1 at b. Not limited to the
/// segment; not finite where a equals b. `Vec` is Vec2 or Vec3.
template <class Vec>
double foot_on_line(const Vec& a, const Vec& b, const Vec& p) {
  const Vec along = b - a;
  return along.dot(p - a) / along.squaredNorm();
}

}  // namespace gvd
