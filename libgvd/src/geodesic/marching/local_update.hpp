#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/plane.hpp"
#include "gvd/front.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A triangle A, B, D in coordinates along its base A B: the frame of the local distance update. Mesh units.
struct UpdateTriangle {
  double base;          ///< |A B|, > 0
  double inverse_base;  ///< 1 / |A B|
  double side_a;        ///< |A D|
  double side_b;        ///< |B D|
  double x;             ///< foot of D on the base, measured from A towards B
  double height;        ///< distance of D from the base, >= 0
};

/// The frame of a triangle from its three lengths, > 0, and twice its area, >= 0.
inline UpdateTriangle make_update_triangle(double base, double side_a, double side_b, double twice_area) {
  const double inverse = 1 / base;
  const double x = apex_foot_by_inverse(base, inverse, side_a, side_b);
  return {base, inverse, side_a, side_b, x, twice_area * inverse};
}

/// The frame of a face on the halfedge of corner `side`.
inline UpdateTriangle make_update_triangle(const FaceShape& s, std::size_t side) {
  return make_update_triangle(s.length[side], s.length[(side + 2) % 3], s.length[(side + 1) % 3], s.twice_area);
}

/// Distance at D along the edges A D and B D: the length of a path of the surface, hence an upper bound.
inline double update_along_edges(const UpdateTriangle& t, double distance_a, double distance_b) {
  return std::min(distance_a + t.side_a, distance_b + t.side_b);
}

/// Distance at corner D of a triangle from those at A and B, by a circular front. Its centre is the image of the point
/// source at these two distances, on the other side of A B.
///
/// Source:  section 4.1 of the paper, with a point source in place of its linear front.
/// Inputs:  distances >= 0 in mesh units
/// Returns: mesh units; at least (distance_a + distance_b - base) / 2, because the ray crosses the base between A and
///   B. It may be less than both distances: a source close behind a long base is nearer to D than to A and B.
/// Properties: (1) symmetric in A and B; (2) exact for a planar point source that sees D through A B; (3) equal to
///   update_along_edges where the distances break the triangle inequality, or where the source does not see D through
///   A B (obtuse triangles): a ray from outside of A B is no path of the surface; (4) it does not decrease when a
///   distance grows, if the height is not 0 and distance_a + distance_b > base: when distance_b grows, the source
///   turns around A away from B, and its angle to D at A, which is at most pi, grows.
/// Cost: O(1), two square roots.
inline double update_circle(const UpdateTriangle& t, double distance_a, double distance_b) {
  const double source_x = apex_foot_by_inverse(t.base, t.inverse_base, distance_a, distance_b);
  const double depth_squared = (distance_a - source_x) * (distance_a + source_x);
  if (depth_squared < 0) return update_along_edges(t, distance_a, distance_b);
  const double depth = std::sqrt(depth_squared);
  // The ray from the source to D crosses the base at (source_x height + x depth) / (depth + height).
  const double span = depth + t.height;
  const double crossing = source_x * t.height + t.x * depth;
  if (crossing < 0 || crossing > t.base * span) return update_along_edges(t, distance_a, distance_b);
  const double dx = t.x - source_x;
  return std::sqrt(dx * dx + span * span);
}

/// The same with a front that is linear over the triangle: the planar front of the paper.
///
/// Source:  section 4.1 of the paper (fast marching of Kimmel and Sethian, 1998).
/// Properties: (1) symmetric in A and B; (2) exact for a plane wave; (3) equal to update_along_edges where no
///   characteristic reaches D through A B; (4) it does not decrease when a distance grows: its derivatives are the
///   barycentric coordinates of the point where the characteristic crosses the base.
/// Cost: O(1), one square root.
inline double update_planar(const UpdateTriangle& t, double distance_a, double distance_b) {
  const double slope = (distance_b - distance_a) * t.inverse_base;  // the sine of the front's tilt
  const double cosine_squared = 1 - slope * slope;
  if (cosine_squared <= 0) return update_along_edges(t, distance_a, distance_b);
  const double cosine = std::sqrt(cosine_squared);
  // The characteristic through D crosses the base at x - height slope / cosine.
  const double crossing = t.x * cosine - t.height * slope;
  if (crossing < 0 || crossing > t.base * cosine) return update_along_edges(t, distance_a, distance_b);
  return distance_a + slope * t.x + cosine * t.height;
}

/// The update by a front of either shape.
inline double update_by(Front front, const UpdateTriangle& t, double distance_a, double distance_b) {
  return front == Front::circle ? update_circle(t, distance_a, distance_b) : update_planar(t, distance_a, distance_b);
}

/// The two halves of a face, cut by the median from corner C to the opposite edge A B. They do not depend on the
/// generator.
struct MedianHalves {
  UpdateTriangle at_a, at_b;  ///< base from C to A, or to B; the apex is the midpoint of A B
};

/// The halves for the edge of corner `side`. Cost: O(1), one square root.
inline MedianHalves make_median_halves(const FaceShape& shape, std::size_t side) {
  const double length = shape.length[side], bc = shape.length[(side + 1) % 3], ca = shape.length[(side + 2) % 3];
  // The median from C, by the parallelogram law.
  const double median = std::sqrt(std::max(0.0, 0.5 * (bc * bc + ca * ca) - 0.25 * length * length));
  const double twice_area = 0.5 * shape.twice_area;  // of one half
  return {make_update_triangle(ca, median, 0.5 * length, twice_area),
          make_update_triangle(bc, median, 0.5 * length, twice_area)};
}

/// Distance at the midpoint of corner `side`'s edge, updated through the face from its two other edges: the auxiliary
/// distance of section 4.1. `corner`: the generator's distances at the face's corners, mesh units. Cost: O(1).
inline double auxiliary_distance(const MedianHalves& halves, const std::array<double, 3>& corner, std::size_t side,
                                 Front front) {
  const double a = corner[side], b = corner[(side + 1) % 3], c = corner[(side + 2) % 3];
  return std::min(update_by(front, halves.at_a, c, a), update_by(front, halves.at_b, c, b));
}

}  // namespace gvd
