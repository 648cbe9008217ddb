#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The points between two points on a shortest path from a to b; none where one face contains both.
/// Throws Error{precondition} if they lie on two components. Cost: that of distances from b up to twice that of a, and O(n).
std::vector<SurfacePoint> join_points(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

}  // namespace gvd
