// Places generators on creases.
//
// There is a generator on each corner, and between corners generators are evenly spaced by length, so that no cell
// reaches across a corner. Points are snapped to vertices first and then to edges, so that a point written with few
// digits returns to its vertex.
#include "crease_generators.hpp"

#include <algorithm>
#include <cmath>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "mesh/creases.hpp"

namespace gvd {
namespace {

/// Places generators between the ends of a curve.
void place_along(const Mesh& mesh, const CreaseCurve& curve, double spacing, FeatureGenerators& placed) {
  const double length = total_length(mesh, curve.edges);
  const bool is_loop = curve.vertices.front() == curve.vertices.back();  // even a coarse loop has at least three edges
  const double parts = std::max(std::round(length / spacing), is_loop ? 3.0 : 1.0);
  std::vector<double> at;
  for (double k = curve.closed ? 0 : 1; k < parts; ++k) at.push_back(length * k / parts);
  for (const SurfacePoint& point : points_on_curve(mesh, curve, at)) {
    placed.points.push_back(point);
    placed.freedom.push_back(Freedom::on_crease);
  }
}

/// The nearest vertex on a crease in the faces of a point, within a distance; invalid if there is none.
VertexId nearest_crease_vertex(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point,
                               double distance) {
  const Vec3 at = position(mesh, point);
  Least<VertexId> nearest;
  for (const FaceId f : faces_around(mesh, point)) {
    for (const VertexId v : mesh.vertices(f)) {
      const double here = (mesh.position(v) - at).norm();
      if (here <= distance && !network.leaving(v).empty()) nearest.offer(here, v);
    }
  }
  return nearest.value;
}

/// The nearest point on the creases in the faces of a point, within a distance; otherwise the point itself.
SurfacePoint nearest_on_edges(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point,
                              double distance) {
  const Vec3 at = position(mesh, point);
  SurfacePoint nearest = point;
  double least = distance;
  for (const FaceId f : faces_around(mesh, point)) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!network.is_crease(mesh.edge(h))) continue;
      const SurfacePoint foot = edge_point(h, std::clamp(foot_on_edge(mesh, h, at), 0.0, 1.0));
      const double here = (position(mesh, foot) - at).norm();
      if (!(here <= least)) continue;
      nearest = foot;
      least = here;
    }
  }
  return nearest;
}

}  // namespace

std::vector<SurfacePoint> snap_to_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                          std::vector<SurfacePoint> points, double distance) {
  const CreaseNetwork network(mesh, creases);
  for (SurfacePoint& point : points) {
    if (point.kind() == SurfacePoint::Kind::vertex) continue;
    const VertexId v = nearest_crease_vertex(mesh, network, point, distance);
    if (v.valid()) {
      point = vertex_point(mesh, v);
    } else if (!network.contains(point)) {
      point = nearest_on_edges(mesh, network, point, distance);
    }
  }
  return points;
}

std::vector<Freedom> freedoms_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                         const std::vector<SurfacePoint>& points) {
  const CreaseNetwork network(mesh, creases);
  std::vector<Freedom> freedoms;
  for (const SurfacePoint& p : points) {
    const bool is_vertex = p.kind() == SurfacePoint::Kind::vertex;
    const bool is_corner = is_vertex && network.contains(p) && network.is_corner(vertex(mesh, p));
    freedoms.push_back(is_corner ? Freedom::fixed : network.contains(p) ? Freedom::on_crease : Freedom::free);
  }
  return freedoms;
}

FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                   double corner_distance) {
  if (!(spacing > 0)) throw Error(ErrorCode::invalid_option, "the spacing of generators on creases must be above 0");
  const CreaseNetwork network(mesh, creases, corner_distance);
  FeatureGenerators placed;
  for (const VertexId v : mesh.vertices()) {
    if (network.leaving(v).empty() || !network.is_corner(v)) continue;
    placed.points.push_back(vertex_point(mesh, v));
    placed.freedom.push_back(Freedom::fixed);
  }
  for (const CreaseCurve& curve : trace_curves(mesh, network, creases)) place_along(mesh, curve, spacing, placed);
  return placed;
}

}  // namespace gvd
