#include <algorithm>

#include "gvd/dual.hpp"
#include "gvd/surface_normal.hpp"

namespace gvd {

std::vector<FaceId> find_flipped_faces(const Mesh& surface, const Mesh& remesh,
                                       const std::vector<SurfacePoint>& generators,
                                       const std::vector<SurfacePoint>& face_points) {
  std::vector<Vec3> normals;
  for (const SurfacePoint& generator : generators) normals.push_back(surface_normal(surface, generator));
  std::vector<FaceId> flipped;
  for (std::int32_t i = 0; i < remesh.face_count(); ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = remesh.vertices(f);
    const Vec3 ab = remesh.position(b) - remesh.position(a), ac = remesh.position(c) - remesh.position(a);
    const Vec3 bc = remesh.position(c) - remesh.position(b);
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
    const Vec3 area = ab.cross(ac);
    const Vec3 mean =
        normals[a.index()] + normals[b.index()] + normals[c.index()] + surface_normal(surface, face_points[f.index()]);
    const bool has_area = area.norm() > kFlipTolerance * longest;
    if (!has_area || !(area.dot(mean) > kFlipTolerance * area.norm() * mean.norm())) flipped.push_back(f);
  }
  return flipped;
}

}  // namespace gvd
