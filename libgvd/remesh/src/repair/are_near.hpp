#pragma once

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Whether two points are near each other along the surface: one connected part of the surface within the Euclidean
/// distance `radius` of `a` holds both. Points on the two banks of a slit, or on two sheets that touch, are near in
/// space only. Where the radius is less than the surface's features, this agrees with the geodesic distance.
/// Cost: O(k log k) for k faces within the radius; O(1) where the points are farther apart than that in space.
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius);

}  // namespace gvd
