// Shape figures of triangles and valences, as section 5 of the paper tabulates them for remeshes.
//
// Q compares the area with the half perimeter and the longest edge, and is 1 for equilateral triangles alone. Angles
// come from atan2 of cross and dot product, which keeps the digits of very small and very flat ones.
// Invariant: sums run over the faces in the order of their ids, so that a figure has the same last digit on every run.
#include "gvd/quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace gvd {
namespace {

/// An angle counts as below 30 degrees if it is smaller by more than this. In degrees. With coordinates of 12 digits an
/// angle of 30 degrees is off by about 1e-10, and the triangles of a regular mesh must not count.
constexpr double kAngleSlack = 1e-9;

double angle_at(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

}  // namespace

double compute_q(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double longest = std::max({ab, bc, ca});
  if (longest == 0) return 0;
  const double area = (b - a).cross(c - a).norm() / 2;
  const double half_perimeter = (ab + bc + ca) / 2;
  return std::min(1.0, 6 / std::numbers::sqrt3 * area / (half_perimeter * longest));
}

double compute_min_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::min({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

TriangleQuality compute_triangle_quality(const Mesh& mesh) {
  TriangleQuality quality;
  if (mesh.face_count() == 0) return quality;
  quality.q_min = 1;
  quality.angle_min = 60;
  std::int32_t below = 0;
  for (const FaceId f : mesh.faces()) {
    const auto& [i, j, k] = mesh.vertices(f);
    const Vec3 &a = mesh.position(i), &b = mesh.position(j), &c = mesh.position(k);
    const double q = compute_q(a, b, c), angle = compute_min_angle(a, b, c);
    quality.q_min = std::min(quality.q_min, q);
    quality.q_average += q;
    quality.angle_min = std::min(quality.angle_min, angle);
    quality.angle_min_average += angle;
    if (angle < 30 - kAngleSlack) ++below;
  }
  quality.q_average /= mesh.face_count();
  quality.angle_min_average /= mesh.face_count();
  quality.percent_below_30 = 100.0 * below / mesh.face_count();
  return quality;
}

Valences compute_valences(const Mesh& mesh) {
  if (mesh.vertex_count() == 0) return {};
  IdVector<VertexId, std::int32_t> edges(mesh.vertex_count(), 0);
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    ++edges[mesh.from(h)];
    ++edges[mesh.to(h)];
  }
  const auto [least, largest] = std::minmax_element(edges.begin(), edges.end());
  std::int32_t regular = 0;
  for (const VertexId v : mesh.vertices()) regular += edges[v] == (mesh.is_boundary(v) ? 4 : 6);
  return {*least, *largest, 100.0 * regular / mesh.vertex_count()};
}

}  // namespace gvd
