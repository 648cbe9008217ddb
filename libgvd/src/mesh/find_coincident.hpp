#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Returns for each point the index of the first point that coincides with it, which may be the point itself. Two
/// points coincide if they are closer than the coincidence distance of the mesh and lie in faces that share a vertex.
/// So points of two sheets that touch do not coincide.
/// Cost: O(n log n).
std::vector<std::int32_t> find_coincident(const Mesh& mesh, const std::vector<SurfacePoint>& points);

}  // namespace gvd
