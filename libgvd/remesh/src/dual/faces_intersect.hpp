#pragma once

#include "dual/placed_faces.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Whether a closed segment and a closed triangle have a common point. Exact; either may be degenerate.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& triangle);

/// Whether two different faces have a common point outside of the vertex or edge that they share. Exact.
///
/// Two faces that share an edge intersect only if they are folded flat onto each other. Two faces that share a vertex
/// intersect if the opposite edge of one meets the other: their common points form a convex set that contains the
/// vertex, and so reaches one of these edges. Two faces with the same three vertices intersect.
bool faces_intersect(const PlacedFace& f, const PlacedFace& g);

inline bool faces_intersect(const PlacedFaces& faces, FaceId f, FaceId g) {
  return faces_intersect(faces.at(f), faces.at(g));
}

}  // namespace gvd
