// Triangles that are turned against the surface, or have no area.
#include "dual/flipped_triangles.hpp"

#include <algorithm>
#include <array>

#include "gvd/dual.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

bool is_flipped(const Triangle& triangle, const Vec3& normal) {
  const auto& [a, b, c] = triangle;
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const Vec3 area = (b - a).cross(c - a);
  const bool has_area = area.norm() > kFlipTolerance * longest;
  return !has_area || !(area.dot(normal) > kFlipTolerance * area.norm() * normal.norm());
}

bool is_surface_triangle(const Mesh& surface, const Mesh& remesh, FaceId face,
                         const std::vector<SurfacePoint>& generators, const std::vector<SurfacePoint>& face_points) {
  std::array<VertexId, 3> corners, own = surface.vertices(face_points[face.index()].face);
  for (int i = 0; i < 3; ++i) {
    const VertexId corner = remesh.vertices(face)[i];
    const SurfacePoint& point = generators[corner.index()];
    if (point.kind() != SurfacePoint::Kind::vertex) return false;
    corners[i] = vertex(surface, point);
    if (remesh.position(corner) != surface.position(corners[i])) return false;
  }
  for (auto* const triangle : {&corners, &own}) {
    std::rotate(triangle->begin(), std::min_element(triangle->begin(), triangle->end()), triangle->end());
  }
  return corners == own;
}

std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points) {
  std::vector<Vec3> at_generator, at_face;
  for (const SurfacePoint& generator : generators) at_generator.push_back(surface_normal(surface, generator));
  for (const FaceId f : remesh.faces()) {
    const auto& [a, b, c] = remesh.vertices(f);
    at_face.push_back(at_generator[a.index()] + at_generator[b.index()] + at_generator[c.index()] +
                      surface_normal(surface, face_points[f.index()]));
  }
  return at_face;
}

std::vector<FaceId> find_flipped_faces(const Mesh& surface, const Mesh& remesh,
                                       const std::vector<SurfacePoint>& generators,
                                       const std::vector<SurfacePoint>& face_points) {
  const std::vector<Vec3> normals = normals_at_faces(surface, remesh, generators, face_points);
  std::vector<FaceId> flipped;
  for (const FaceId f : remesh.faces()) {
    if (!is_flipped(PlacedFaces(remesh).corners(f), normals[f.index()])) continue;
    if (!is_surface_triangle(surface, remesh, f, generators, face_points)) flipped.push_back(f);
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
    if (is_flipped({positions[a.index()], positions[b.index()], positions[c.index()]}, mean)) flipped.push_back(i);
  }
  return flipped;
}

}  // namespace gvd
