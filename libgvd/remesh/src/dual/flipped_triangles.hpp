#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dual/placed_faces.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Whether a triangle is degenerate, or flipped against a normal of any length (kFlipTolerance). Cost: O(1).
bool is_flipped(const Triangle& triangle, const Vec3& normal);

/// Whether a face of a remesh is a triangle of the surface: its corners stand for the corners of the face in which its
/// point lies, and are at the same positions. `generators` and `face_points` belong to the remesh. Cost: O(1).
bool is_surface_triangle(const Mesh& surface, const Mesh& remesh, FaceId face,
                         const std::vector<SurfacePoint>& generators, const std::vector<SurfacePoint>& face_points);

/// The sum of the surface's unit normals at the three generators and the branch point of each face of a remesh.
std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points);

}  // namespace gvd
