#pragma once

#include <cmath>

#include "gvd/vec.hpp"

namespace gvd {

/// The angle between two vectors in radians, in [0, pi]; 0 if one of them is zero. It is computed from both sine and
/// cosine, because acos alone loses digits near 0 and pi.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace gvd
