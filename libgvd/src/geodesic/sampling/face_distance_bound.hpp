#pragma once

#include <array>

#include "gvd/mesh.hpp"

namespace gvd {

/// An upper bound on the distance of every point p of a triangle, from the distances of its corners: the maximum over p
/// of min over corners i of distance[i] + |p - corner i|.
///
/// Inputs:  distances in mesh units. Those of two corners differ by at most the length of their side (triangle
///   inequality).
/// Returns: mesh units; in [largest distance, largest distance + longest side / sqrt(3)].
/// Properties: (1) non-decreasing in each distance; (2) symmetric in the corners; (3) attained if the path to each corner
///   continues the segment from p to that corner.
/// Cost: O(1), a square root.
double compute_face_distance_bound(const FaceShape& face, const std::array<double, 3>& distance);

}  // namespace gvd
