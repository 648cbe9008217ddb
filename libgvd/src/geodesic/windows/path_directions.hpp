#pragma once

#include <array>
#include <optional>

#include "base/plane.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A range of directions, from `right` counter-clockwise to `left`, which are less than half a turn apart.
struct Directions {
  Vec2 right, left;

  void include(const Vec2& d) {
    if (cross(left, d) > 0) left = d;
    if (cross(right, d) < 0) right = d;
  }
  bool contains(const Vec2& d) const {
    return cross(right, d) >= 0 && cross(d, left) >= 0 && (d.dot(right) > 0 || d.dot(left) > 0);
  }
  bool is_below_half_turn() const { return cross(right, left) > 0 || right.dot(left) > 0; }
};

/// The directions of a source's straight paths at the points of a triangle. Nothing if no straight path reaches it.
inline std::optional<Directions> directions_of(const FaceSource& s, const std::array<Vec2, 3>& triangle) {
  if (s.is_parallel()) return Directions{s.direction(), s.direction()};
  std::optional<Directions> found;
  for (const Vec2& corner : triangle) {
    const Vec2 ray = corner - s.image;
    if (ray.isZero(0)) continue;
    if (!found) found = Directions{ray, ray};
    found->include(ray);
  }
  if (!found || s.is_corner()) return found;
  const Vec2 to_begin = s.begin - s.image, to_end = s.end - s.image;
  if (cross(found->right, to_begin) < 0 || cross(found->left, to_end) > 0) return std::nullopt;
  if (cross(found->left, to_begin) < 0) found->left = to_begin;
  if (cross(found->right, to_end) > 0) found->right = to_end;
  return found;
}

/// The direction of a source's shortest path at p; zero at the source.
inline Vec2 direction_of(const FaceSource& s, const Vec2& p) {
  const Vec2 last = p - s.shortest_path(p).from;
  const double length = last.norm();
  return length > 0 ? Vec2(last / length) : Vec2::Zero();
}

}  // namespace gvd
