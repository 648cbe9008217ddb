#include "gvd/surface_normal.hpp"

#include <cmath>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

Vec3 normalized_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

}  // namespace

Vec3 face_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return normalized_or_zero((mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)));
}

double corner_angle(const Mesh& mesh, HalfedgeId h) {
  const Vec3 along = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  const Vec3 other = mesh.position(mesh.opposite(h)) - mesh.position(mesh.from(h));
  return std::atan2(along.cross(other).norm(), along.dot(other));
}

namespace {

Vec3 vertex_normal(const Mesh& mesh, VertexId v) {
  Vec3 sum = Vec3::Zero();
  for_each_outgoing(mesh, v, [&](HalfedgeId h) { sum += corner_angle(mesh, h) * face_normal(mesh, Mesh::face(h)); });
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

}  // namespace gvd
