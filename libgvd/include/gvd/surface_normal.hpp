#pragma once

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Unit normal of a face; zero for one without area. Cost: O(1).
Vec3 face_normal(const Mesh& mesh, FaceId f);

/// Angle of the corner where a halfedge begins, in radians, from 0 to pi. Cost: O(1).
double corner_angle(const Mesh& mesh, HalfedgeId h);

/// Unit normal of the surface at a point: inside a face its normal, on an edge the mean of its two faces, at a vertex
/// the mean of its faces weighted by their angles. Zero where all these faces have no area. Cost: O(valence).
Vec3 surface_normal(const Mesh& mesh, const SurfacePoint& point);

}  // namespace gvd
