#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/plane.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using Cube = std::array<std::int64_t, 3>;

/// Where a point lies round a vertex of its face, with the fan of the vertex unrolled: its distance from the vertex and
/// its angle from the side by which one enters the face counter-clockwise.
struct Polar {
  double radius, angle;
  Polar(const Mesh& mesh, HalfedgeId outgoing, const Vec3& p) {
    const Vec3 apex = mesh.position(mesh.from(outgoing)), side = mesh.position(mesh.to(outgoing)) - apex;
    radius = (p - apex).norm();
    angle = std::atan2(side.cross(p - apex).norm(), side.dot(p - apex));
  }
  double distance(const Polar& other, double turn) const {
    const double between = turn + other.angle - angle;
    if (between >= std::numbers::pi) return radius + other.radius;
    return (radius * unit_vector(angle) - other.radius * unit_vector(turn + other.angle)).norm();
  }
};

double angle_between_outgoing(const Mesh& mesh, HalfedgeId outgoing) {
  const Vec3 apex = mesh.position(mesh.from(outgoing)), side = mesh.position(mesh.to(outgoing)) - apex;
  const Vec3 other = mesh.position(mesh.from(Mesh::previous(outgoing))) - apex;
  return std::atan2(side.cross(other).norm(), side.dot(other));
}

/// Distance from p, in the face of a halfedge, to q in face g, counter-clockwise through the fan of the vertex that the
/// halfedge leaves; infinite where the fan does not lead there.
double distance_through_fan(const Mesh& mesh, HalfedgeId from, const Vec3& p, FaceId g, const Vec3& q) {
  const Polar start(mesh, from, p);
  double turn = 0;
  for (HalfedgeId h = from; h.valid();) {
    if (Mesh::face(h) == g) return start.distance(Polar(mesh, h, q), turn);
    turn += angle_between_outgoing(mesh, h);
    h = next_outgoing(mesh, h);
    if (h == from) break;
  }
  return std::numeric_limits<double>::infinity();
}

/// Distance of two points along the surface, through the fans of the vertices that their faces have in common: exact
/// for points that are much nearer than their faces are large. Infinite where the faces have no vertex in common.
double distance_along_surface(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const Vec3 p = position(mesh, a), q = position(mesh, b);
  if (a.face == b.face) return (p - q).norm();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const HalfedgeId h = Mesh::halfedge(a.face, i);
    least = std::min(least, distance_through_fan(mesh, h, p, b.face, q));
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId other = Mesh::halfedge(b.face, k);
      if (mesh.from(other) == mesh.from(h)) least = std::min(least, distance_through_fan(mesh, other, q, a.face, p));
    }
  }
  return least;
}

/// The points so far, in cubes with the tolerance as side: closer points lie in the same cube or in adjacent ones.
class Grid {
 public:
  Grid(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {
    if (mesh.vertex_count() > 0) origin_ = mesh.position(VertexId(0));
  }

  /// Returns the smallest index of an earlier point that coincides with this one. Without one, inserts the point and
  /// returns its own index.
  std::int32_t insert(const SurfacePoint& point, std::int32_t index) {
    const Vec3 location = position(mesh_, point);
    const Cube centre = cube(location);
    std::int32_t first = index;
    for (int i = 0; i < 27; ++i) {
      const Cube near{centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1};
      const auto found = cubes_.find(near);
      if (found == cubes_.end()) continue;
      for (const Entry& other : found->second) {
        if ((other.location - location).norm() > tolerance_) continue;
        if (distance_along_surface(mesh_, other.point, point) <= tolerance_) first = std::min(first, other.index);
      }
    }
    if (first == index) cubes_[centre].push_back({location, point, index});
    return first;
  }

 private:
  struct Entry {
    Vec3 location;
    SurfacePoint point;
    std::int32_t index;
  };

  Cube cube(const Vec3& location) const {
    const Vec3 scaled = (location - origin_) / tolerance_;
    return {std::llround(scaled.x()), std::llround(scaled.y()), std::llround(scaled.z())};
  }

  const Mesh& mesh_;
  double tolerance_;
  Vec3 origin_ = Vec3::Zero();
  std::map<Cube, std::vector<Entry>> cubes_;
};

}  // namespace

std::vector<std::int32_t> find_coincident(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  Grid grid(mesh, std::max(coincidence(mesh), std::numeric_limits<double>::denorm_min()));
  std::vector<std::int32_t> first;
  first.reserve(points.size());
  for (const SurfacePoint& point : points) {
    first.push_back(grid.insert(canonical(mesh, point), static_cast<std::int32_t>(first.size())));
  }
  return first;
}

}  // namespace gvd
