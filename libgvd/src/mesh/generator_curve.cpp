// Makes curves that can be generators, and checks curves.
//
// A curve is checked before work begins, so that the code that inserts it can rely on points in faces and on connected
// segments.
//
// The curves of a mesh are connected groups of its edges: see creases.hpp.
#include "gvd/generator_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/error.hpp"
#include "mesh/creases.hpp"

namespace gvd {
namespace {

/// Throws an error that names the curve by its number, also in `Error::element`.
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
  if (parts > 1) refuse(number, fmt::format("consists of {} separate parts; make each part a curve of its own", parts));
}

/// Makes a curve of each connected group of edges. Its points are the group's vertices in ascending order, so the first
/// point does not depend on the order of the edges.
std::vector<GeneratorCurve> collect_curves(const Mesh& mesh, const std::vector<EdgeId>& edges) {
  std::vector<GeneratorCurve> curves;
  for (const CreaseGroup& group : group_creases(mesh, edges)) {
    GeneratorCurve& curve = curves.emplace_back();
    for (const VertexId v : group.vertices) curve.points.push_back(vertex_point(mesh, v));
    const auto point = [&](VertexId v) {
      return std::int32_t(std::ranges::lower_bound(group.vertices, v) - group.vertices.begin());
    };
    for (const EdgeId e : group.edges) {
      curve.segments.push_back({point(mesh.from(mesh.halfedge(e))), point(mesh.to(mesh.halfedge(e)))});
    }
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
  return collect_curves(mesh, find_creases(mesh, {.with_boundary = true}));
}

std::vector<GeneratorCurve> crease_curves(const Mesh& mesh, double angle) {
  return collect_curves(mesh, find_creases(mesh, {.angle = angle}));
}

}  // namespace gvd
