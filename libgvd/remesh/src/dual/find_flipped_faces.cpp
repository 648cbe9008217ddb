#include "dual/flipped_triangle.hpp"
#include "gvd/dual.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

std::vector<FaceId> find_flipped_faces(const Mesh& surface, const Mesh& remesh,
                                       const std::vector<SurfacePoint>& generators,
                                       const std::vector<SurfacePoint>& face_points) {
  const std::vector<Vec3> normals = normals_at_faces(surface, remesh, generators, face_points);
  std::vector<FaceId> flipped;
  for (std::int32_t i = 0; i < remesh.face_count(); ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = remesh.vertices(f);
    const Vec3 &p = remesh.position(a), &q = remesh.position(b), &r = remesh.position(c);
    if (is_flipped(p, q, r, normals[f.index()])) flipped.push_back(f);
  }
  return flipped;
}

std::vector<std::size_t> find_flipped_triangles(const Mesh& surface, const Diagram& diagram, const DualMesh& dual) {
  std::vector<Vec3> positions, normals;
  for (const SurfacePoint& generator : diagram.generators) {
    positions.push_back(position(surface, generator));
    normals.push_back(surface_normal(surface, generator));
  }
  std::vector<std::size_t> flipped;
  for (std::size_t i = 0; i < dual.faces.size(); ++i) {
    const auto& [a, b, c] = dual.faces[i];
    const Vec3 at_branch = surface_normal(surface, diagram.branch_points[dual.branch_points[i]].point);
    const Vec3 mean = normals[a.index()] + normals[b.index()] + normals[c.index()] + at_branch;
    if (is_flipped(positions[a.index()], positions[b.index()], positions[c.index()], mean)) flipped.push_back(i);
  }
  return flipped;
}

}  // namespace gvd
