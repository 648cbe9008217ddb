#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Length of the bisector's polyline, mesh units; that of a closed one lacks its last segment. Cost: O(points).
double compute_length(const Mesh& mesh, const Bisector& bisector);

/// The point of the bisector's polyline nearest to the middle of an open bisector, by arc length. Cost: O(points).
SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector);

}  // namespace gvd
