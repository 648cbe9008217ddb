#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gvd/vec.hpp"

namespace gvd {

/// Cross product in the plane: > 0 where b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v, rotated counter-clockwise by 90 degrees.
inline Vec2 turned_left(const Vec2& v) { return {-v.y(), v.x()}; }

/// The unit vector at this angle from the x axis, in radians.
inline Vec2 unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Twice the signed area of a triangle: > 0 if a, b, c are counter-clockwise. Rounding can change the sign;
/// `orientation` returns the sign where it is certain.
inline double twice_signed_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

/// Twice the signed area of a polygon of n corners (the shoelace formula). `corner(i)` is a Vec2.
template <class Corner>
double twice_signed_area(std::size_t n, const Corner& corner) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += cross(corner(i), corner((i + 1) % n));
  return sum;
}

/// Bound on the rounding error of an orientation, relative to the sum of its two products: (3 + 16 e) e for the
/// rounding unit e = 2^-53, rounded up. Dimensionless.
inline constexpr double kOrientationError = 3.4e-16;

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 if rounding makes it uncertain.
///
/// Source: the filter of J. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
/// 1997. A result other than 0 is exact, unless a product underflows.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double area = left - right;
  if (std::abs(area) <= kOrientationError * (std::abs(left) + std::abs(right))) return 0;
  return area > 0 ? 1 : -1;
}

/// The foot of a triangle's apex on its base, measured from the base's first end and computed from the lengths of the
/// three sides. The two other sides may be distances to a point source, whose image is then the apex. This is the law
/// of cosines, with the difference of two squares written as a product so that nothing cancels if the sides are long
/// and nearly equal.
///
/// Inputs: mesh units, base > 0. Returns: mesh units; outside [0, base] if an angle at the base is obtuse.
inline double apex_foot(double base, double first_side, double second_side) {
  return 0.5 * (base + (first_side - second_side) * (first_side + second_side) / base);
}

/// Like `apex_foot`, for loops that have already computed 1 / base. The results may differ in the last digit.
inline double apex_foot_by_inverse(double base, double inverse_base, double first_side, double second_side) {
  return 0.5 * (base + (first_side - second_side) * (first_side + second_side) * inverse_base);
}

/// An axis-aligned box in the plane, border included. A default-constructed box is empty.
using Box2 = Eigen::AlignedBox2d;

/// The smallest box that contains two points.
inline Box2 bounding_box(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

/// A straight line segment in the plane.
struct PlaneSegment {
  Vec2 from, to;
};

/// The parameter of the point of a segment that is nearest to p: 0 at its beginning `from`, 1 at its end from + along;
/// 0 for a segment of length 0. `Point` is Vec2 or Vec3.
template <class Point>
double nearest_on_segment(const Point& from, const Point& along, const Point& p) {
  const double square = along.squaredNorm();
  return square > 0 ? std::clamp((p - from).dot(along) / square, 0.0, 1.0) : 0;
}

/// The parameters of the common point p + s d = q + t e of two lines.
struct LineIntersection {
  double s, t;
};

/// Where the line through p along d crosses the line through q along e. Not finite where the lines are parallel.
inline LineIntersection intersect_lines(const Vec2& p, const Vec2& d, const Vec2& q, const Vec2& e) {
  const Vec2 between = q - p;
  const double denominator = cross(d, e);
  return {cross(between, e) / denominator, cross(between, d) / denominator};
}

// The next three predicates tell whether segments cross. They differ in their answer when rounding makes it uncertain.

/// Whether two segments may cross or touch other than at a common end. The answer is never false for segments that
/// cross, so that a search based on it misses no crossing.
inline bool may_intersect(const PlaneSegment& a, const PlaneSegment& b) {
  if (!bounding_box(a.from, a.to).intersects(bounding_box(b.from, b.to))) return false;
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return false;
  return orientation(a.from, a.to, b.from) * orientation(a.from, a.to, b.to) <= 0 &&
         orientation(b.from, b.to, a.from) * orientation(b.from, b.to, a.to) <= 0;
}

/// Whether two segments cross by more than `tolerance`: the ends of each lie on different sides of the other's line,
/// and each end forms a triangle with the other segment whose area, doubled, exceeds the tolerance. This is for checks
/// that must not fail because of rounding.
inline bool intersect_beyond(const PlaneSegment& a, const PlaneSegment& b, double tolerance) {
  const auto separates = [tolerance](const PlaneSegment& line, const PlaneSegment& other) {
    const double from = twice_signed_area(line.from, line.to, other.from);
    const double to = twice_signed_area(line.from, line.to, other.to);
    return std::min(from, to) < -tolerance && std::max(from, to) > tolerance;
  };
  return separates(a, b) && separates(b, a);
}

/// Whether p and q lie strictly on the same side of the segment's line; rounding can change the answer.
inline bool lie_on_one_side(const PlaneSegment& line, const Vec2& p, const Vec2& q) {
  return twice_signed_area(line.from, line.to, p) * twice_signed_area(line.from, line.to, q) > 0;
}

}  // namespace gvd
