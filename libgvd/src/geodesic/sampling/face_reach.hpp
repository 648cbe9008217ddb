#pragma once

#include <array>

namespace gvd {

/// An upper bound on the distance of every point of a triangle, from the distances of its corners: the largest value of
/// min over corners i of distance[i] + |p - corner i|.
///
/// Inputs:  lengths of the sides 0-1, 1-2, 2-0, twice the area, distances; mesh units. The distances of two corners
/// differ by
///   no more than their side, as distances do.
/// Returns: mesh units; never less than the largest distance, never above it by more than the longest side / sqrt(3).
/// Properties: (1) falls where a distance falls; (2) symmetric in the corners; (3) exact where each corner is reached
///   from straight outside.
/// Cost: O(1), a square root.
double compute_reach(const std::array<double, 3>& length, double twice_area, const std::array<double, 3>& distance);

}  // namespace gvd
