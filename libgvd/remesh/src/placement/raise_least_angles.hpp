#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// Moves vertices of thin triangles along the surface, one after the other, so that the smallest angle around each
/// grows.
///
/// `movable`: of each vertex, whether it may move. Vertices of triangles with an angle below `least_angle` (degrees)
/// try eight directions with steps that get shorter, and keep the best place. Source: optimisation-based smoothing
/// (L. Freitag and C. Ollivier-Gooch, Tetrahedral mesh improvement using swapping and smoothing, 1997), with a search
/// in place of the linear programs. A triangle may get thinner, but not below `least_angle`. Deterministic. Cost:
/// O(n), and O(valence) for each of kAngleTrials places of a vertex that moves.
std::vector<Vec3> raise_least_angles(const Mesh& mesh, const std::vector<char>& movable, double least_angle);

/// Passes over the vertices, and places that a vertex tries in one.
inline constexpr int kAnglePasses = 6, kAngleTrials = 32;

}  // namespace gvd
