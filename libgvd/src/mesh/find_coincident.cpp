// Finds points at the same place of the surface.
//
// Two points coincide if they are close along the surface; points of two sheets that touch are different points at one
// position. Points that are close lie in faces with a common vertex, whose fan is unrolled into a plane to measure
// their distance. A grid of cubes, whose side is the tolerance, finds the earlier points that are near in space: they
// lie in 27 cubes.
#include "mesh/find_coincident.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/angles.hpp"
#include "base/plane.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The place of a point in the unrolled fan of a vertex: its distance from the vertex, and its angle from the first
/// side of its face, counter-clockwise.
struct Polar {
  double radius, angle;
  Polar(const Mesh& mesh, HalfedgeId outgoing, const Vec3& p) {
    const Vec3& apex = mesh.position(mesh.from(outgoing));
    const Vec3 side = mesh.position(mesh.to(outgoing)) - apex;
    radius = (p - apex).norm();
    angle = angle_between(side, p - apex);
  }
  double distance(const Polar& other, double turn) const {
    const double between = turn + other.angle - angle;
    if (between >= std::numbers::pi) return radius + other.radius;
    return (radius * unit_vector(angle) - other.radius * unit_vector(turn + other.angle)).norm();
  }
};

/// The distance from p to q, counter-clockwise through the fan of the vertex that the halfedge `from` leaves. p lies in
/// the face of `from`, and q in face g. Infinite if the fan does not reach g.
double distance_through_fan(const Mesh& mesh, HalfedgeId from, const Vec3& p, FaceId g, const Vec3& q) {
  const Polar start(mesh, from, p);
  double turn = 0;
  for (HalfedgeId h = from; h.valid();) {
    if (Mesh::face(h) == g) return start.distance(Polar(mesh, h, q), turn);
    turn += corner_angle(mesh, h);
    h = next_outgoing(mesh, h);
    if (h == from) break;
  }
  return kInfinity;
}

/// The distance of two points along the surface, through the fans of the vertices that their faces have in common. It
/// is exact for points that are much nearer to each other than their faces are large, and infinite if the faces have no
/// common vertex.
double distance_along_surface(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const Vec3 p = position(mesh, a), q = position(mesh, b);
  if (a.face == b.face) return (p - q).norm();
  double least = kInfinity;
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

}  // namespace

std::vector<std::int32_t> find_coincident(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  struct Kept {
    Vec3 location;
    SurfacePoint point;
    std::int32_t index;
  };
  using Cube = std::array<std::int64_t, 3>;
  std::map<Cube, std::vector<Kept>> cubes;  // the points that coincide with no earlier point
  const double tolerance = std::max(coincidence(mesh), std::numeric_limits<double>::denorm_min());
  const Vec3 origin = mesh.vertex_count() > 0 ? mesh.position(VertexId(0)) : Vec3(0, 0, 0);
  std::vector<std::int32_t> first;
  first.reserve(points.size());
  for (const SurfacePoint& given : points) {
    const SurfacePoint point = canonical(mesh, given);
    const auto index = std::int32_t(first.size());
    const Vec3 location = position(mesh, point), scaled = (location - origin) / tolerance;
    const Cube cube{std::llround(scaled.x()), std::llround(scaled.y()), std::llround(scaled.z())};
    std::int32_t found = index;
    for (int i = 0; i < 27; ++i) {
      const auto near = cubes.find({cube[0] + i % 3 - 1, cube[1] + i / 3 % 3 - 1, cube[2] + i / 9 - 1});
      if (near == cubes.end()) continue;
      for (const Kept& other : near->second) {
        if ((other.location - location).norm() > tolerance) continue;
        if (distance_along_surface(mesh, other.point, point) <= tolerance) found = std::min(found, other.index);
      }
    }
    if (found == index) cubes[cube].push_back({location, point, index});
    first.push_back(found);
  }
  return first;
}

}  // namespace gvd
