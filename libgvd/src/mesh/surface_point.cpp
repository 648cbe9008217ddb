#include "gvd/surface_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "mesh/point_views.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// How far given coordinates may lie below 0 (rounding of a projection), and how far their sum may differ from 1 (six
/// printed digits). Dimensionless.
constexpr double kNegativeSlack = 1e-9;
constexpr double kSumSlack = 1e-6;

std::array<double, 3> unit(std::size_t corner) {
  std::array<double, 3> bary{0, 0, 0};
  bary[corner] = 1;
  return bary;
}

}  // namespace

SurfacePoint::Kind SurfacePoint::kind() const {
  const auto zeros = std::count(bary.begin(), bary.end(), 0.0);
  return zeros == 2 ? Kind::vertex : zeros == 1 ? Kind::edge : Kind::face;
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

SurfacePoint vertex_point(const Mesh& mesh, VertexId v) {
  const HalfedgeId h = mesh.halfedge(v);
  return {Mesh::face(h), unit(static_cast<std::size_t>(Mesh::corner(h)))};
}

SurfacePoint edge_point(HalfedgeId h, double t) {
  std::array<double, 3> bary{0, 0, 0};
  bary[Mesh::corner(h)] = 1 - t;
  bary[Mesh::corner(Mesh::next(h))] = t;
  return {Mesh::face(h), bary};
}

Vec3 position(const Mesh& mesh, const SurfacePoint& point) {
  const auto& [a, b, c] = mesh.vertices(point.face);
  return interpolate(point.bary, mesh.position(a), mesh.position(b), mesh.position(c));
}

double interpolate_at(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
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
  return Mesh::next(Mesh::halfedge(point.face, static_cast<int>(zero)));
}

bool is_on_boundary(const Mesh& mesh, const SurfacePoint& point) {
  switch (point.kind()) {
    case SurfacePoint::Kind::vertex:
      return mesh.is_boundary(vertex(mesh, point));
    case SurfacePoint::Kind::edge:
      return mesh.is_boundary(mesh.edge(halfedge(point)));
    case SurfacePoint::Kind::face:
      break;
  }
  return false;
}

std::vector<FaceId> faces_around(const Mesh& mesh, const SurfacePoint& point) {
  std::vector<FaceId> faces;
  if (point.kind() == SurfacePoint::Kind::vertex) {
    for_each_outgoing(mesh, vertex(mesh, point), [&](HalfedgeId h) { faces.push_back(Mesh::face(h)); });
    return faces;
  }
  faces.push_back(point.face);
  if (point.kind() == SurfacePoint::Kind::edge) {
    const HalfedgeId twin = mesh.twin(halfedge(point));
    if (twin.valid()) faces.push_back(Mesh::face(twin));
  }
  return faces;
}

SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point) {
  switch (point.kind()) {
    case SurfacePoint::Kind::vertex: {
      HalfedgeId best = mesh.halfedge(vertex(mesh, point));
      for_each_outgoing(mesh, vertex(mesh, point), [&](HalfedgeId h) { best = std::min(best, h); });
      return {Mesh::face(best), unit(static_cast<std::size_t>(Mesh::corner(best)))};
    }
    case SurfacePoint::Kind::edge: {
      const auto across = find_view_across(mesh, point);
      return across && across->face < point.face ? *across : point;
    }
    case SurfacePoint::Kind::face:
      break;
  }
  return point;
}

}  // namespace gvd
