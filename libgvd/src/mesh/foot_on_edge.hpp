#pragma once

#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Where the foot of a point on the line of a halfedge is: 0 at the halfedge's start, 1 at its end. Not limited to the
/// edge, and not finite where the edge has no length. Cost: O(1).
inline double foot_on_edge(const Mesh& mesh, HalfedgeId h, const Vec3& point) {
  const Vec3 &from = mesh.position(mesh.from(h)), along = mesh.position(mesh.to(h)) - from;
  return along.dot(point - from) / along.squaredNorm();
}

}  // namespace gvd
