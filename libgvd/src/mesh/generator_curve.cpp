// Curves that can be generators: those of a mesh, and what all of them have to fulfil.
//
// A curve is checked before work begins, so that what inserts it may count on points in faces and on connected
// segments.
//
// The curves of a mesh are connected sets of its edges: union-find over the vertices gives the sets, in the order of
// their first vertices.
#include "gvd/generator_curve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Throws with the curve's number, which `element` of the error holds too.
[[noreturn]] void refuse(std::size_t curve, const std::string& why) {
  throw Error(ErrorCode::precondition, fmt::format("curve {} {}", curve, why), std::int64_t(curve));
}

void check_curve(const Mesh& mesh, const GeneratorCurve& curve, std::size_t number) {
  const auto count = std::int32_t(curve.points.size());
  if (count == 0) refuse(number, "has no point");
  for (const SurfacePoint& p : curve.points) {
    if (!p.face.valid() || p.face.value() >= mesh.face_count()) {
      refuse(number, fmt::format("has a point in face {}, and the mesh has {}", p.face.value(), mesh.face_count()));
    }
  }
  UnionFind sets(count);
  std::int32_t parts = count;
  for (const auto& [a, b] : curve.segments) {
    if (a < 0 || b < 0 || a >= count || b >= count) {
      refuse(number, fmt::format("has a segment from point {} to point {}, and {} points", a, b, count));
    }
    if (!find_common_view(mesh, curve.points[a], curve.points[b])) {
      refuse(number, fmt::format("jumps from point {} to point {}: no face contains both; add the points where it "
                                 "crosses edges",
                                 a, b));
    }
    if (sets.find(a) == sets.find(b)) continue;
    sets.unite(a, b);
    --parts;
  }
  if (parts > 1) refuse(number, fmt::format("has {} parts; make each one a curve of its own", parts));
}

/// The connected sets of some edges, each with its vertices in their order. So the first point of a curve is the vertex
/// with the least number, whatever edges it has.
std::vector<GeneratorCurve> collect_curves(const Mesh& mesh, const std::vector<EdgeId>& edges) {
  UnionFind sets(mesh.vertex_count());
  for (const EdgeId e : edges) {
    sets.unite(mesh.from(mesh.halfedge(e)).value(), mesh.to(mesh.halfedge(e)).value());
  }
  IdVector<VertexId, std::uint8_t> is_used(mesh.vertex_count(), 0);
  for (const EdgeId e : edges) is_used[mesh.from(mesh.halfedge(e))] = is_used[mesh.to(mesh.halfedge(e))] = 1;
  std::vector<GeneratorCurve> curves;
  IdVector<VertexId, std::int32_t> curve_of(mesh.vertex_count(), -1), point_of(mesh.vertex_count(), -1);
  for (const VertexId v : mesh.vertices()) {
    if (is_used[v] == 0) continue;
    std::int32_t& curve = curve_of[VertexId(sets.find(v.value()))];
    if (curve < 0) {
      curve = std::int32_t(curves.size());
      curves.emplace_back();
    }
    point_of[v] = std::int32_t(curves[curve].points.size());
    curves[curve].points.push_back(vertex_point(mesh, v));
  }
  for (const EdgeId e : edges) {
    const VertexId from = mesh.from(mesh.halfedge(e)), to = mesh.to(mesh.halfedge(e));
    curves[curve_of[VertexId(sets.find(from.value()))]].segments.push_back({point_of[from], point_of[to]});
  }
  return curves;
}

}  // namespace

GeneratorCurve make_polyline(std::vector<SurfacePoint> points, bool closed) {
  GeneratorCurve curve{std::move(points)};
  const auto count = std::int32_t(curve.points.size());
  for (std::int32_t i = 1; i < count; ++i) curve.segments.push_back({i - 1, i});
  if (closed && count > 2) curve.segments.push_back({count - 1, 0});
  return curve;
}

std::vector<std::vector<Vec3>> polylines(const Mesh& mesh, const GeneratorCurve& curve) {
  std::vector<std::vector<Vec3>> lines;
  std::int32_t last = -1;
  for (const auto& [a, b] : curve.segments) {
    if (a != last) lines.push_back({position(mesh, curve.points[a])});
    lines.back().push_back(position(mesh, curve.points[b]));
    last = b;
  }
  return lines;
}

void check_curves(const Mesh& mesh, const std::vector<GeneratorCurve>& curves) {
  if (curves.empty()) throw Error(ErrorCode::precondition, "there is no curve; give at least one");
  for (std::size_t i = 0; i < curves.size(); ++i) check_curve(mesh, curves[i], i);
}

std::vector<GeneratorCurve> boundary_curves(const Mesh& mesh) {
  std::vector<EdgeId> edges;
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_boundary(e)) edges.push_back(e);
  }
  return collect_curves(mesh, edges);
}

std::vector<GeneratorCurve> crease_curves(const Mesh& mesh, double least_angle) {
  std::vector<EdgeId> edges;
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_boundary(e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    const Vec3 here = face_normal(mesh, Mesh::face(h)), there = face_normal(mesh, Mesh::face(mesh.twin(h)));
    if (here.isZero() || there.isZero()) continue;
    if (std::atan2(here.cross(there).norm(), here.dot(there)) > least_angle) edges.push_back(e);
  }
  return collect_curves(mesh, edges);
}

}  // namespace gvd
