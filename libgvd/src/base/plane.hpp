#pragma once

#include "gvd/vec.hpp"

namespace gvd {

/// Twice the signed area between a and b: > 0 where b is on the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Turns v by a quarter, counter-clockwise.
inline Vec2 turned_left(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace gvd
