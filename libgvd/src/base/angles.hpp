#pragma once

#include <cmath>

#include "gvd/vec.hpp"

namespace gvd {

/// The angle between two vectors, radians, in [0, pi]; 0 where one of them is 0. By sine and cosine, so that no digits
/// are lost near 0 and pi.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace gvd
