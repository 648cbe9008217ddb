#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

namespace gvd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The distance of what no generator reaches, and the bound of what is not bounded.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace gvd
