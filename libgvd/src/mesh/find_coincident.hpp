#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// For each point the index of the first point that coincides with it, which may be itself. Two points coincide where
/// they are closer than the coincidence distance of the mesh and lie in faces that share a vertex: points of two sheets
/// that touch do not.
/// Cost: O(n log n).
std::vector<std::int32_t> find_coincident(const Mesh& mesh, const std::vector<SurfacePoint>& points);

}  // namespace gvd
