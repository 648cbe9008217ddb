// Restricts moves of generators: anywhere, along a crease, or not at all.
//
// Tangent vectors at points of creases use the frame of geodesic_tracing.hpp, so that a path along a crease has a
// length and a final direction, like a geodesic.
#include "constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

using CreaseStep = CreaseNetwork::Step;

/// The direction of a step at a point of its edge.
Vec2 direction_of(const Mesh& mesh, const SurfacePoint& point, const CreaseStep& step) {
  const HalfedgeId h = mesh.halfedge(step.edge);
  if (point.kind() == SurfacePoint::Kind::edge) {
    const bool along = halfedge(point) == h;  // the tangent plane's x axis is the direction of the point's halfedge
    return {along == step.forwards ? 1.0 : -1.0, 0};
  }
  const Vec2 side = FaceLayout(mesh, Mesh::face(h)).side(Mesh::corner(h));
  return unit_vector(TangentFan(mesh, point).angle(Mesh::face(h), step.forwards ? side : Vec2(-side)));
}

/// The two directions along the crease from a point that is no corner.
std::array<CreaseStep, 2> ways_from(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point) {
  if (point.kind() == SurfacePoint::Kind::vertex) {
    const std::vector<CreaseStep>& steps = network.leaving(vertex(mesh, point));
    return {steps[0], steps[1]};
  }
  const EdgeId e = mesh.edge(halfedge(point));
  return {CreaseStep{e, true}, CreaseStep{e, false}};
}

}  // namespace

Vec2 project_to_crease(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point, const Vec2& tangent) {
  if (point.kind() == SurfacePoint::Kind::vertex && network.is_corner(vertex(mesh, point))) return Vec2::Zero();
  Vec2 best = Vec2::Zero();
  for (const CreaseStep& way : ways_from(mesh, network, point)) {
    const Vec2 along = direction_of(mesh, point, way);
    const double length = tangent.dot(along);
    if (length > best.norm()) best = length * along;
  }
  return best;
}

GeodesicTrace follow_crease(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point,
                            const Vec2& tangent) {
  GeodesicTrace trace;
  trace.points.push_back(point);
  const double wanted = tangent.norm();
  if (!(wanted > 0)) return trace;
  const auto [one, other] = ways_from(mesh, network, point);
  const bool is_one = direction_of(mesh, point, one).dot(tangent) >= direction_of(mesh, point, other).dot(tangent);
  CreaseStep step = is_one ? one : other;
  double from = 0;  // distance from the start of the first edge
  if (point.kind() == SurfacePoint::Kind::edge) {
    from = (position(mesh, point) - mesh.position(network.start(step))).norm();
  }
  double rest = from + wanted, passed = -from;
  // The limit keeps the path from following a closed crease more than once.
  for (int i = 0; i < mesh.edge_count(); ++i) {
    const double length = mesh.length(step.edge);
    const CreaseStep after = rest > length ? network.next(step) : CreaseStep{};
    if (!after.edge.valid()) break;
    rest -= length;
    passed += length;
    step = after;
  }
  const double last = std::min(rest, mesh.length(step.edge));
  const SurfacePoint end = point_on_edge(mesh, step.edge, network.start(step), last);
  trace.points.push_back(end);
  trace.length = passed + last;
  trace.complete = trace.length >= wanted;
  // At a vertex, which may be a corner, the direction continues straight from the edge.
  const bool is_inside = end.kind() == SurfacePoint::Kind::edge;
  trace.direction =
      is_inside ? direction_of(mesh, end, step) : Vec2(-direction_of(mesh, end, {step.edge, !step.forwards}));
  return trace;
}

void GeneratorConstraints::check(const std::vector<SurfacePoint>& generators) const {
  if (freedom_.empty()) return;
  if (freedom_.size() != generators.size()) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} given for {}", counted(std::ssize(freedom_), "freedom is", "freedoms are"),
                            counted(std::ssize(generators), "generator", "generators")));
  }
  for (int i = 0; i < std::ssize(generators); ++i) {
    if (freedom_[i] != Freedom::on_crease || network_->contains(generators[i])) continue;
    throw Error(ErrorCode::precondition, fmt::format("generator {} has to stay on a crease and lies on none", i), i);
  }
}

Vec2 GeneratorConstraints::project(const Mesh& mesh, std::size_t generator, const SurfacePoint& point,
                                   const Vec2& tangent) const {
  if (of(generator) == Freedom::on_crease) return project_to_crease(mesh, *network_, point, tangent);
  return is_free(generator) ? project_to_surface(mesh, point, tangent) : Vec2(0, 0);
}

GeodesicTrace GeneratorConstraints::move(const Mesh& mesh, std::size_t generator, const SurfacePoint& point,
                                         const Vec2& step) const {
  if (of(generator) == Freedom::on_crease) {
    return follow_crease(mesh, *network_, point, project_to_crease(mesh, *network_, point, step));
  }
  return trace_geodesic(mesh, point, is_free(generator) ? step : Vec2(0, 0));
}

}  // namespace gvd
