// The largest distance that a point of a face may have.
//
// Idea: on each side and inside, the farthest point is the one whose paths over the corners are equally long.
// Source: the problem of Apollonius.
// Invariant: the bound is never below the distance of a point, because the distance of a point is at most the length of
// its path over any corner.
#include "geodesic/sampling/face_distance_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/plane.hpp"

namespace gvd {
namespace {

/// A point whose barycentric coordinates exceed this counts as inside. The tolerance is safe, because so close to a
/// side the value equals the value on the side within rounding.
constexpr double kBesideFace = -1e-9;

constexpr double kNoBound = -kInfinity;

/// The largest r for which a point p of the triangle has distance[i] + |p - corner i| = r for all three corners
/// (the problem of Apollonius). kNoBound if there is no such r, NaN for a degenerate triangle.
double solve_apollonius(const FaceShape& face, const std::array<double, 3>& distance) {
  // Corner 0 lies at the origin, corner 1 at (x1, 0), corner 2 at (x2, y2).
  const auto& length = face.length;
  const double x1 = length[0], x2 = apex_foot(length[0], length[2], length[1]), y2 = face.twice_area / length[0];
  const auto contains = [&](double x, double y) {
    const double bary2 = y / y2, bary1 = (x - bary2 * x2) / x1;
    return bary1 > kBesideFace && bary2 > kBesideFace && 1 - bary1 - bary2 > kBesideFace;
  };
  // Let s = r - distance[0] and step i = distance[i] - distance[0]. Subtracting the circle round corner 0 from that
  // round corner i gives 2 p . corner i = |corner i|^2 - (step i)^2 + 2 (step i) s, hence p = u + v s.
  const double step1 = distance[1] - distance[0], step2 = distance[2] - distance[0];
  const double ux = (x1 * x1 - step1 * step1) / (2 * x1), vx = step1 / x1;
  const double uy = (length[2] * length[2] - step2 * step2 - 2 * x2 * ux) / (2 * y2), vy = (step2 - x2 * vx) / y2;
  // |u + v s|^2 = s^2 is a s^2 + 2 b s + c = 0; solved without cancellation.
  const double a = vx * vx + vy * vy - 1, b = ux * vx + uy * vy, c = ux * ux + uy * uy;
  const double q = -b - std::copysign(std::sqrt(std::max(0.0, b * b - a * c)), b);
  if (std::isnan(q)) return q;
  double best = kNoBound;
  for (const double s : {q / a, c / q}) {
    if (s >= std::max({0.0, step1, step2}) && contains(ux + vx * s, uy + vy * s))
      best = std::max(best, distance[0] + s);
  }
  return best;
}

}  // namespace

// The value is the minimum of three convex functions whose gradients have length 1 and point away from the corners. At
// a local maximum inside the triangle all three are equal; on a side, two are; at a corner, the value is at most the
// corner's distance.
double compute_face_distance_bound(const FaceShape& face, const std::array<double, 3>& distance) {
  const auto& length = face.length;
  const double largest = *std::max_element(distance.begin(), distance.end());
  const double limit = largest + *std::max_element(length.begin(), length.end()) / std::numbers::sqrt3;
  double on_sides = largest;
  for (std::size_t i = 0; i < 3; ++i) {
    on_sides = std::max(on_sides, 0.5 * (distance[i] + distance[(i + 1) % 3] + length[i]));
  }
  const double inside = solve_apollonius(face, distance);
  if (std::isnan(inside) || on_sides > limit) return limit;
  return std::clamp(inside, on_sides, limit);
}

}  // namespace gvd
