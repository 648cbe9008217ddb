#include "dual/flipped_triangle.hpp"

#include <algorithm>

#include "gvd/dual.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

bool is_flipped(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const Vec3 area = (b - a).cross(c - a);
  const bool has_area = area.norm() > kFlipTolerance * longest;
  return !has_area || !(area.dot(normal) > kFlipTolerance * area.norm() * normal.norm());
}

std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points) {
  std::vector<Vec3> at_generator, at_face;
  for (const SurfacePoint& generator : generators) at_generator.push_back(surface_normal(surface, generator));
  for (std::int32_t i = 0; i < remesh.face_count(); ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = remesh.vertices(f);
    at_face.push_back(at_generator[a.index()] + at_generator[b.index()] + at_generator[c.index()] +
                      surface_normal(surface, face_points[f.index()]));
  }
  return at_face;
}

}  // namespace gvd
