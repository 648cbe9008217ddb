#pragma once

#include "gvd/vec.hpp"

namespace gvd {

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 on the line. Exact.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The side of the plane through a, b and c on which d lies. 1: a, b and c appear counter-clockwise from d; -1: the
/// other side; 0: in the plane, or a, b and c lie on a line. Exact, unless a product underflows.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace gvd
