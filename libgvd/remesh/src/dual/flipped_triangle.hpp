#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Whether a triangle is degenerate, or flipped against a normal of any length: see kFlipTolerance. Cost: O(1).
bool is_flipped(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);

/// For each face of a remesh the sum of the surface's unit normals at its three generators and its branch point.
std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points);

}  // namespace gvd
