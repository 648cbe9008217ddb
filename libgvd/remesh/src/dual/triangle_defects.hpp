#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Defects of the triangles of a dual, beside those of its topology (check_dual).

namespace gvd {

/// Whether a triangle is degenerate, or flipped against a normal of any length: see kFlipTolerance. Cost: O(1).
bool is_flipped(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);

/// The sum of the surface's unit normals at the three generators and the branch point of each face of a remesh.
std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points);

/// A triangle of a dual, by index, as a defect. `what` follows "the triangle of the generators a, b and c".
DualDefect triangle_defect(const Diagram& diagram, const DualMesh& dual, std::size_t triangle, const std::string& what,
                           DualProperty property = DualProperty::not_flipped);

}  // namespace gvd
