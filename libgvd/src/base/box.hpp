#pragma once

#include <limits>

#include "gvd/vec.hpp"

namespace gvd {

/// An axis-aligned box of the plane, with its border. Empty where low > high.
struct Box2 {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = Vec2::Constant(-std::numeric_limits<double>::infinity());

  bool is_empty() const { return low.x() > high.x(); }
};

/// The box of two points.
inline Box2 bounding_box(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

/// The box of two boxes.
inline Box2 unite(const Box2& a, const Box2& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

/// Whether two boxes have a point in common; never true of an empty one.
inline bool overlap(const Box2& a, const Box2& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace gvd
