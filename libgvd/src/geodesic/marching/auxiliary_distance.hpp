#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geodesic/marching/local_update.hpp"
#include "gvd/front.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

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
  const double twice_area = 0.5 * shape.twice_area;  // a half's
  return {make_update_triangle(ca, median, 0.5 * length, twice_area),
          make_update_triangle(bc, median, 0.5 * length, twice_area)};
}

/// Distance at the midpoint of corner `side`'s edge, updated through the face from its two other edges: the auxiliary
/// distance of section 4.1. `corner`: the generator's distances at the face's corners, mesh units. Cost: O(1).
inline double auxiliary_distance(const MedianHalves& halves, const std::array<double, 3>& corner, std::size_t side,
                                 Front front) {
  const double a = corner[side], b = corner[(side + 1) % 3], c = corner[(side + 2) % 3];
  const auto update = front == Front::circle ? update_circle : update_planar;
  return std::min(update(halves.at_a, c, a), update(halves.at_b, c, b));
}

}  // namespace gvd
