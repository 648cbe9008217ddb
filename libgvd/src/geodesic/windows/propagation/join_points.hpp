#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The inner points of a shortest path from a to b; none if one face contains both. Throws Error{precondition} if a and
/// b lie on two components. Cost: O(n), and that of distances from b up to twice the distance of a.
std::vector<SurfacePoint> join_points(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

}  // namespace gvd
