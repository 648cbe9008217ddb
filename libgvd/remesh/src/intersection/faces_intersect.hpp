#pragma once

#include <array>

#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

using Triangle = std::array<Vec3, 3>;

/// Whether a closed segment and a closed triangle have a common point. Exact; either may be degenerate.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& triangle);

/// Whether two different faces of a mesh have a common point outside of the vertex or edge that they share. Exact.
///
/// Two faces of one edge intersect only where they are folded flat onto each other. Two faces of one vertex intersect
/// where the opposite edge of one meets the other. Why: what they have in common is convex and holds the vertex, so it
/// ends on one of these edges. Two faces of the same three vertices intersect.
bool faces_intersect(const Mesh& mesh, FaceId f, FaceId g);

}  // namespace gvd
