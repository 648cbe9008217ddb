#pragma once

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Unit normal of the surface at a point: that of the face at a point inside it, the mean of two at a point on an edge,
/// the mean weighted by angles at a vertex. Zero where faces without area leave none. Cost: O(valence).
Vec3 surface_normal(const Mesh& mesh, const SurfacePoint& point);

}  // namespace gvd
