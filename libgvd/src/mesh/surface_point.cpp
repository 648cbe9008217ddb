// Points of the surface: their kinds, positions and normals, and their coordinates in each face that contains them.
//
// A point on an edge lies in two faces, and a point at a vertex lies in all faces around it. Its view in each of these
// faces names the same point; the canonical view is the view in the face with the smallest id.
// Invariant: a barycentric coordinate is exactly 0 where a point lies on an edge or a vertex, so its kind is a fact and
// no later step needs a tolerance. A point on an edge has the same two weights in both faces, and each view of a vertex
// has one weight of 1, so equal points have equal canonical views.
#include "gvd/surface_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.hpp"
#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using PointKind = SurfacePoint::Kind;

/// How far given coordinates may lie below 0, because of a rounded projection, and how far their sum may differ from 1,
/// because of six printed digits. Dimensionless.
constexpr double kNegativeSlack = 1e-9;
constexpr double kSumSlack = 1e-6;

/// The vertex that a halfedge leaves, as a point.
SurfacePoint corner_point(HalfedgeId h) { return edge_point(h, 0); }

Vec3 normalized_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

/// If the sum of three coordinates differs from 1 by at most this, the coordinates are kept bit by bit. Dimensionless.
/// It is above the rounding error of computed coordinates, and below the error of coordinates with few printed digits,
/// which are scaled.
constexpr double kExactSum = 1e-12;

}  // namespace

PointKind SurfacePoint::kind() const {
  const auto zeros = std::count(bary.begin(), bary.end(), 0.0);
  return zeros == 2 ? PointKind::vertex : zeros == 1 ? PointKind::edge : PointKind::face;
}

SurfacePoint make_surface_point(FaceId face, const std::array<double, 3>& bary) {
  const double sum = bary[0] + bary[1] + bary[2];
  if (!std::isfinite(sum) || std::abs(sum - 1) > kSumSlack ||
      *std::min_element(bary.begin(), bary.end()) < -kNegativeSlack) {
    throw Error(ErrorCode::precondition,
                fmt::format("barycentric coordinates {} {} {} must not be negative and must sum to 1", bary[0], bary[1],
                            bary[2]),
                face.value());
  }
  SurfacePoint point{face, bary};
  double kept = 0;
  for (double& b : point.bary) {
    if (b <= kBarycentricSnap) b = 0;
    kept += b;
  }
  for (double& b : point.bary) b /= kept;
  return point;
}

SurfacePoint restore_surface_point(FaceId face, const std::array<double, 3>& bary) {
  const auto is_kept = [](double b) { return b == 0 || (b >= 0.5 * kBarycentricSnap && b <= 1); };
  const bool whole = std::all_of(bary.begin(), bary.end(), is_kept);
  // JSON has no -0. Adding 0 turns it into 0, so that a list means the same in each format.
  if (whole && std::abs(bary[0] + bary[1] + bary[2] - 1) <= kExactSum) {
    return {face, {bary[0] + 0.0, bary[1] + 0.0, bary[2] + 0.0}};
  }
  return make_surface_point(face, bary);
}

SurfacePoint vertex_point(const Mesh& mesh, VertexId v) { return corner_point(mesh.halfedge(v)); }

SurfacePoint edge_point(HalfedgeId h, double t) {
  SurfacePoint point{Mesh::face(h), {0, 0, 0}};
  point.bary[Mesh::corner(h)] = 1 - t;
  point.bary[Mesh::corner(Mesh::next(h))] = t;
  return point;
}

double coincidence(const Mesh& mesh) {
  return std::max(kCoincidence * mesh.bbox_diagonal(), kCoordinateRounding * mesh.largest_coordinate());
}

Vec3 position(const Mesh& mesh, const SurfacePoint& point) {
  const auto& [a, b, c] = mesh.vertices(point.face);
  return interpolate(point.bary, mesh.position(a), mesh.position(b), mesh.position(c));
}

double interpolate_at(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (point.bary[i] > 0) sum += point.bary[i] * values[mesh.vertices(point.face)[i]];
  }
  return sum;
}

VertexId vertex(const Mesh& mesh, const SurfacePoint& point) {
  const auto corner = std::max_element(point.bary.begin(), point.bary.end()) - point.bary.begin();
  return mesh.vertices(point.face)[corner];
}

HalfedgeId halfedge(const SurfacePoint& point) {
  const auto zero = std::find(point.bary.begin(), point.bary.end(), 0.0) - point.bary.begin();
  return Mesh::next(HalfedgeId(3 * point.face.value() + zero));
}

bool is_on_boundary(const Mesh& mesh, const SurfacePoint& point) {
  const PointKind kind = point.kind();
  if (kind == PointKind::vertex) return mesh.is_boundary(vertex(mesh, point));
  return kind == PointKind::edge && mesh.is_boundary(mesh.edge(halfedge(point)));
}

std::vector<FaceId> faces_around(const Mesh& mesh, const SurfacePoint& point) {
  std::vector<FaceId> faces;
  if (point.kind() == PointKind::vertex) {
    for_each_outgoing(mesh, vertex(mesh, point), [&](HalfedgeId h) { faces.push_back(Mesh::face(h)); });
    return faces;
  }
  faces.push_back(point.face);
  if (point.kind() == PointKind::edge) {
    const HalfedgeId twin = mesh.twin(halfedge(point));
    if (twin.valid()) faces.push_back(Mesh::face(twin));
  }
  return faces;
}

SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point) {
  return point.kind() == PointKind::face ? point : find_views(mesh, point).front();
}

std::optional<SurfacePoint> find_view_across(const Mesh& mesh, const SurfacePoint& point) {
  const HalfedgeId h = halfedge(point), twin = mesh.twin(h);
  if (!twin.valid()) return std::nullopt;
  SurfacePoint across{Mesh::face(twin), {0, 0, 0}};
  const auto weight = [&](HalfedgeId at) { return point.bary[Mesh::corner(at)]; };
  across.bary[Mesh::corner(twin)] = weight(Mesh::next(h));
  across.bary[Mesh::corner(Mesh::next(twin))] = weight(h);
  return across;
}

std::vector<SurfacePoint> find_views(const Mesh& mesh, const SurfacePoint& point) {
  std::vector<SurfacePoint> views;
  const PointKind kind = point.kind();
  if (kind == PointKind::vertex) {
    for_each_outgoing(mesh, vertex(mesh, point), [&](HalfedgeId h) { views.push_back(corner_point(h)); });
  } else {
    views.push_back(point);
    const auto across = kind == PointKind::edge ? find_view_across(mesh, point) : std::nullopt;
    if (across) views.push_back(*across);
  }
  std::sort(views.begin(), views.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
  return views;
}

std::optional<std::pair<SurfacePoint, SurfacePoint>> find_common_view(const Mesh& mesh, const SurfacePoint& a,
                                                                      const SurfacePoint& b) {
  const std::vector<SurfacePoint> views_a = find_views(mesh, a), views_b = find_views(mesh, b);
  for (const SurfacePoint& view_a : views_a) {
    for (const SurfacePoint& view_b : views_b) {
      if (view_a.face == view_b.face) return std::pair(view_a, view_b);
    }
  }
  return std::nullopt;
}

Vec3 face_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return normalized_or_zero((mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)));
}

double corner_angle(const Mesh& mesh, HalfedgeId h) {
  const Vec3 along = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  const Vec3 other = mesh.position(mesh.opposite(h)) - mesh.position(mesh.from(h));
  return angle_between(along, other);
}

Vec3 surface_normal(const Mesh& mesh, const SurfacePoint& point) {
  Vec3 sum = Vec3::Zero();
  if (point.kind() == PointKind::vertex) {
    for_each_outgoing(mesh, vertex(mesh, point),
                      [&](HalfedgeId h) { sum += corner_angle(mesh, h) * face_normal(mesh, Mesh::face(h)); });
    return normalized_or_zero(sum);
  }
  sum = face_normal(mesh, point.face);  // a sum that begins with 0 would lose the sign of a zero
  const HalfedgeId twin = point.kind() == PointKind::edge ? mesh.twin(halfedge(point)) : HalfedgeId();
  if (twin.valid()) sum += face_normal(mesh, Mesh::face(twin));
  return normalized_or_zero(sum);
}

}  // namespace gvd
