#include "mesh/point_views.hpp"

#include <algorithm>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

std::vector<SurfacePoint> views_of_vertex(const Mesh& mesh, VertexId v) {
  std::vector<SurfacePoint> views;
  for_each_outgoing(mesh, v, [&](HalfedgeId h) { views.push_back(edge_point(h, 0)); });
  return views;
}

std::vector<SurfacePoint> views_of_edge_point(const Mesh& mesh, const SurfacePoint& point) {
  const auto across = find_view_across(mesh, point);
  return across ? std::vector<SurfacePoint>{point, *across} : std::vector<SurfacePoint>{point};
}

}  // namespace

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
  std::vector<SurfacePoint> views{point};
  if (point.kind() == SurfacePoint::Kind::vertex) views = views_of_vertex(mesh, vertex(mesh, point));
  if (point.kind() == SurfacePoint::Kind::edge) views = views_of_edge_point(mesh, point);
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

}  // namespace gvd
