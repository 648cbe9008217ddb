#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Barycentric coordinates in a triangle: the weights of its three corners. They sum to 1 within rounding.
using Bary = std::array<double, 3>;

/// The corners of a triangle in its own coordinates.
inline constexpr std::array<Bary, 3> kWholeTriangle{Bary{1, 0, 0}, Bary{0, 1, 0}, Bary{0, 0, 1}};

/// Converts a point of one triangle to the coordinates of another. `corners` are the first triangle's corners in the
/// coordinates of the second one.
inline Bary compose(const std::array<Bary, 3>& corners, const Bary& bary) {
  Bary result{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[k] += bary[i] * corners[i][k];
  }
  return result;
}

/// (1 - t) a + t b.
inline Bary mix(const Bary& a, const Bary& b, double t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

/// The barycentric coordinates of p in a triangle, as ratios of the areas that p spans with the sides.
/// `signed_area(a, b, c)` returns the area of a triangle times any constant. The result is not finite if the triangle
/// has no area.
template <class Point, class SignedArea>
Bary bary_by_areas(const std::array<Point, 3>& corners, const Point& p, const SignedArea& signed_area) {
  const auto& [a, b, c] = corners;
  const double area = signed_area(a, b, c);
  return {signed_area(p, b, c) / area, signed_area(a, p, c) / area, signed_area(a, b, p) / area};
}

/// Interpolates between the values at the three corners, which are numbers, vectors or points.
template <class Value>
Value interpolate(const Bary& bary, const Value& a, const Value& b, const Value& c) {
  return bary[0] * a + bary[1] * b + bary[2] * c;
}

/// Maps a face to the plane affinely, with corner 0 at the origin, corner 1 at (1, 0) and corner 2 at (0, 1). The map
/// keeps orientations and divides areas by 2 area(face).
inline Vec2 affine_point(const Bary& bary) { return {bary[1], bary[2]}; }

/// The signed area of a polygon as a fraction of the area of its face; negative if the polygon is clockwise.
inline double area_share(std::span<const Bary> polygon) {
  return twice_signed_area(polygon.size(), [&](std::size_t i) { return affine_point(polygon[i]); });
}

}  // namespace gvd
