#pragma once

#include <array>

namespace gvd {

/// An upper bound on the distance of every point p of a triangle, from the distances of its corners: the maximum over p
/// of min over corners i of distance[i] + |p - corner i|.
///
/// Inputs:  lengths of the sides 0-1, 1-2, 2-0, twice the area, distances; mesh units. The distances of two corners
///   differ by at most the length of their side (triangle inequality).
/// Returns: mesh units; in [largest distance, largest distance + longest side / sqrt(3)].
/// Properties: (1) non-decreasing in each distance; (2) symmetric in the corners; (3) attained if the path to each corner
///   continues the segment from p to that corner.
/// Cost: O(1), a square root.
double compute_face_distance_bound(const std::array<double, 3>& length, double twice_area,
                                   const std::array<double, 3>& distance);

}  // namespace gvd
