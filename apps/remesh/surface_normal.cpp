#include <cmath>

#include "gvd/dual.hpp"

namespace gvd {
namespace {

Vec3 normalized_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

/// Unit normal of a face; zero for one without area.
Vec3 face_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return normalized_or_zero((mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)));
}

double angle_at(const Mesh& mesh, HalfedgeId h) {
  const Vec3 along = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  const Vec3 other = mesh.position(mesh.opposite(h)) - mesh.position(mesh.from(h));
  return std::atan2(along.cross(other).norm(), along.dot(other));
}

Vec3 vertex_normal(const Mesh& mesh, VertexId v) {
  Vec3 sum = Vec3::Zero();
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    sum += angle_at(mesh, h) * face_normal(mesh, Mesh::face(h));
    h = mesh.twin(Mesh::previous(h));
  } while (h.valid() && h != start);
  return normalized_or_zero(sum);
}

}  // namespace

Vec3 surface_normal(const Mesh& mesh, const SurfacePoint& point) {
  if (point.kind() == SurfacePoint::Kind::vertex) return vertex_normal(mesh, vertex(mesh, point));
  Vec3 sum = face_normal(mesh, point.face);
  if (point.kind() == SurfacePoint::Kind::edge) {
    const HalfedgeId twin = mesh.twin(halfedge(point));
    if (twin.valid()) sum += face_normal(mesh, Mesh::face(twin));
  }
  return normalized_or_zero(sum);
}

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
