#include "remesh_isotropic.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>

namespace gvd::data {
namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Point = Surface::Point;
using Projection = std::function<Vec3(const Vec3&)>;

/// Edges longer than 4/3 of the target are split, shorter than 4/5 collapsed: either brings the length closer to it.
constexpr double kSplitAbove = 4.0 / 3.0;
constexpr double kCollapseBelow = 4.0 / 5.0;
/// Two triangles may be joined or flipped only while their normals' cosine stays above this.
constexpr double kSmallestCosine = 0.5;

Point project(const Projection& projection, const Point& p) {
  const Vec3 q = projection(Vec3(p[0], p[1], p[2]));
  return {q.x(), q.y(), q.z()};
}

Point normal(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a).normalize_cond(); }

Surface build(const Triangles& input) {
  Surface surface;
  std::vector<Surface::VertexHandle> handles;
  for (const Vec3& p : input.positions) handles.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  for (const auto& [a, b, c] : input.faces) {
    surface.add_face(handles[std::size_t(a)], handles[std::size_t(b)], handles[std::size_t(c)]);
  }
  return surface;
}

Triangles extract(const Surface& surface) {
  Triangles result;
  for (const auto v : surface.vertices()) {
    const Point& p = surface.point(v);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : surface.faces()) {
    std::array<int, 3> face{};
    std::size_t corner = 0;
    for (const auto v : f.vertices()) face[corner++] = v.idx();
    result.faces.push_back(face);
  }
  return result;
}

void split_long_edges(Surface& surface, double limit, const Projection& projection) {
  const std::size_t count = surface.n_edges();  // the halves are looked at in the next round
  for (std::size_t i = 0; i < count; ++i) {
    const auto e = surface.edge_handle(static_cast<unsigned>(i));
    if (surface.calc_edge_length(e) <= limit) continue;
    const auto h = surface.halfedge_handle(e, 0);
    const Point middle =
        0.5 * (surface.point(surface.from_vertex_handle(h)) + surface.point(surface.to_vertex_handle(h)));
    surface.split(e, project(projection, middle));
  }
}

/// Whether moving from(h) onto to(h) leaves every edge shorter than `limit` and turns no face too far.
bool collapse_is_good(const Surface& surface, Surface::HalfedgeHandle h, double limit) {
  const auto from = surface.from_vertex_handle(h), to = surface.to_vertex_handle(h);
  const Point& target = surface.point(to);
  for (const auto out : surface.voh_range(from)) {
    const auto a = surface.to_vertex_handle(out);
    const auto b = surface.to_vertex_handle(surface.next_halfedge_handle(out));
    if ((surface.point(a) - target).norm() > limit) return false;
    if (a == to || b == to) continue;
    const Point before = normal(surface.point(from), surface.point(a), surface.point(b));
    if (normal(target, surface.point(a), surface.point(b)).dot(before) < kSmallestCosine) return false;
  }
  return true;
}

void collapse_short_edges(Surface& surface, double low, double high) {
  for (std::size_t i = 0; i < surface.n_edges(); ++i) {
    const auto e = surface.edge_handle(static_cast<unsigned>(i));
    if (surface.status(e).deleted() || surface.calc_edge_length(e) >= low) continue;
    for (const unsigned side : {0u, 1u}) {
      const auto h = surface.halfedge_handle(e, side);
      if (!surface.is_collapse_ok(h) || !collapse_is_good(surface, h, high)) continue;
      surface.collapse(h);
      break;
    }
  }
  surface.garbage_collection();
}

/// Whether the flip brings the four valences closer to 6 and leaves both triangles facing as they did.
bool flip_is_good(const Surface& surface, Surface::EdgeHandle e) {
  const auto h = surface.halfedge_handle(e, 0), g = surface.halfedge_handle(e, 1);
  const auto a = surface.from_vertex_handle(h), b = surface.to_vertex_handle(h);
  const auto c = surface.to_vertex_handle(surface.next_halfedge_handle(h));
  const auto d = surface.to_vertex_handle(surface.next_halfedge_handle(g));
  const auto deviation = [&](Surface::VertexHandle v, int change) {
    const int off = int(surface.valence(v)) + change - 6;
    return off * off;
  };
  const int before = deviation(a, 0) + deviation(b, 0) + deviation(c, 0) + deviation(d, 0);
  if (deviation(a, -1) + deviation(b, -1) + deviation(c, 1) + deviation(d, 1) >= before) return false;
  const Point &pa = surface.point(a), &pb = surface.point(b), &pc = surface.point(c), &pd = surface.point(d);
  const Point outward = (normal(pa, pb, pc) + normal(pb, pa, pd)).normalize_cond();
  return normal(pc, pd, pb).dot(outward) > kSmallestCosine && normal(pd, pc, pa).dot(outward) > kSmallestCosine;
}

void even_out_valences(Surface& surface) {
  for (const auto e : surface.edges()) {
    if (surface.is_flip_ok(e) && flip_is_good(surface, e)) surface.flip(e);
  }
}

/// Moves every vertex towards the mean of its neighbours, then back onto the surface.
void relax(Surface& surface, const Projection& projection) {
  std::vector<Point> moved(surface.n_vertices());
  for (const auto v : surface.vertices()) {
    Point mean(0, 0, 0);
    for (const auto neighbour : v.vertices()) mean += surface.point(neighbour);
    moved[std::size_t(v.idx())] = project(projection, mean / double(surface.valence(v)));
  }
  for (const auto v : surface.vertices()) surface.set_point(v, moved[std::size_t(v.idx())]);
}

}  // namespace

Triangles remesh_isotropic(const Triangles& input, double edge_length, int rounds, const Projection& project) {
  Surface surface = build(input);
  for (int round = 0; round < rounds; ++round) {
    split_long_edges(surface, kSplitAbove * edge_length, project);
    collapse_short_edges(surface, kCollapseBelow * edge_length, kSplitAbove * edge_length);
    even_out_valences(surface);
    relax(surface, project);
  }
  return extract(surface);
}

}  // namespace gvd::data
