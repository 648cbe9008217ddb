#include "crease_network.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/features.hpp"

namespace gvd {
namespace {

/// Number of edges on both sides of a corner, over which the crease turns, too. The boundary of a scan goes to and fro
/// at every vertex.
constexpr int kChordEdges = 5;

}  // namespace

CreaseNetwork::CreaseNetwork(const Mesh& mesh, const std::vector<EdgeId>& creases)
    : mesh_(mesh),
      is_crease_(static_cast<std::size_t>(mesh.edge_count()), false),
      leaving_(static_cast<std::size_t>(mesh.vertex_count())) {
  for (const EdgeId e : creases) {
    is_crease_[e] = true;
    for (const bool forwards : {true, false}) leaving_[start({e, forwards})].push_back({e, forwards});
  }
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    is_corner_.push_back(leaving_[v].size() != 2 || (turns(v, 1) && turns(v, kChordEdges)));
  }
}

bool CreaseNetwork::contains(const SurfacePoint& point) const {
  if (point.kind() == SurfacePoint::Kind::vertex) return !leaving_[vertex(mesh_, point)].empty();
  return point.kind() == SurfacePoint::Kind::edge && is_crease_[mesh_.edge(halfedge(point))];
}

/// Whether the chords over so many edges on both sides turn by more than kCornerTurn.
bool CreaseNetwork::turns(VertexId v, int edges) const {
  return turn_cosine(v, edges) < std::cos(kCornerTurn * std::numbers::pi / 180);
}

double CreaseNetwork::turn_cosine(VertexId v, int edges) const {
  const Vec3 a = chord(leaving_[v][0], edges), b = chord(leaving_[v][1], edges);
  return -a.dot(b) / std::max(a.norm() * b.norm(), std::numeric_limits<double>::min());
}

void CreaseNetwork::thin_corners(double distance) {
  std::vector<std::pair<double, VertexId>> turns;  // the sharpest first
  IdVector<VertexId, bool> kept(leaving_.size(), false);
  for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
    const VertexId v(i);
    if (leaving_[v].empty() || !is_corner_[v]) continue;
    if (leaving_[v].size() == 2) {
      turns.emplace_back(turn_cosine(v, kChordEdges), v);
    } else {
      kept[v] = true;
    }
  }
  std::sort(turns.begin(), turns.end());
  for (const auto& [cosine, v] : turns) {
    kept[v] = !reaches_kept_corner(v, distance, kept);
    is_corner_[v] = kept[v];
  }
}

/// Follows the crease from a turn to both sides.
bool CreaseNetwork::reaches_kept_corner(VertexId v, double distance, const IdVector<VertexId, bool>& kept) const {
  for (Step step : leaving_[v]) {
    double passed = 0;
    while (true) {
      passed += mesh_.length(mesh_.halfedge(step.edge));
      const VertexId to = end(step);
      if (!(passed < distance)) break;
      if (kept[to]) return true;
      if (leaving_[to].size() != 2 || to == v) break;
      step = leaving_[to][leaving_[to][0].edge == step.edge ? 1 : 0];
    }
  }
  return false;
}

/// From the start of the step to the end of the last of so many edges, or to the end of the curve.
Vec3 CreaseNetwork::chord(Step step, int edges) const {
  const VertexId from = start(step);
  for (; edges > 1 && leaving_[end(step)].size() == 2; --edges) {
    const std::vector<Step>& steps = leaving_[end(step)];
    step = steps[steps[0].edge == step.edge ? 1 : 0];
  }
  return mesh_.position(end(step)) - mesh_.position(from);
}

VertexId CreaseNetwork::start(const Step& step) const {
  const HalfedgeId h = mesh_.halfedge(step.edge);
  return step.forwards ? mesh_.from(h) : mesh_.to(h);
}

CreaseNetwork::Step CreaseNetwork::next(const Step& step) const {
  const VertexId v = end(step);
  if (is_corner(v)) return {EdgeId(), true};
  const std::vector<Step>& steps = leaving_[v];
  return steps[steps[0].edge == step.edge ? 1 : 0];
}

SurfacePoint CreaseNetwork::at(const Step& step, double distance) const {
  const HalfedgeId h = mesh_.halfedge(step.edge);
  const double length = mesh_.length(h);
  if (distance <= 0) return vertex_point(mesh_, start(step));
  if (distance >= length) return vertex_point(mesh_, end(step));
  return edge_point(h, step.forwards ? distance / length : 1 - distance / length);
}

Vec2 CreaseNetwork::direction(const SurfacePoint& point, const Step& step) const {
  const HalfedgeId h = mesh_.halfedge(step.edge);
  const Vec2 side = FaceLayout(mesh_, Mesh::face(h)).side(Mesh::corner(h));
  if (point.kind() == SurfacePoint::Kind::edge) {
    const bool along = halfedge(point) == h;  // the tangent plane's x axis runs as the point's own halfedge
    return {along == step.forwards ? 1.0 : -1.0, 0};
  }
  return unit_vector(TangentFan(mesh_, point).angle(Mesh::face(h), step.forwards ? side : Vec2(-side)));
}

std::array<CreaseNetwork::Step, 2> CreaseNetwork::ways(const SurfacePoint& point) const {
  if (point.kind() == SurfacePoint::Kind::vertex) {
    const std::vector<Step>& steps = leaving_[vertex(mesh_, point)];
    return {steps[0], steps[1]};
  }
  const EdgeId e = mesh_.edge(halfedge(point));
  return {Step{e, true}, Step{e, false}};
}

Vec2 CreaseNetwork::project(const SurfacePoint& point, const Vec2& tangent) const {
  if (point.kind() == SurfacePoint::Kind::vertex && is_corner(vertex(mesh_, point))) return Vec2::Zero();
  Vec2 best = Vec2::Zero();
  for (const Step& way : ways(point)) {
    const Vec2 along = direction(point, way);
    const double length = tangent.dot(along);
    if (length > best.norm()) best = length * along;
  }
  return best;
}

GeodesicTrace CreaseNetwork::follow(const SurfacePoint& point, const Vec2& tangent) const {
  GeodesicTrace trace;
  trace.points.push_back(point);
  const double wanted = tangent.norm();
  if (!(wanted > 0)) return trace;
  const auto both = ways(point);
  Step step = both[direction(point, both[0]).dot(tangent) >= direction(point, both[1]).dot(tangent) ? 0 : 1];
  // From the start of the first edge.
  double from = 0;
  if (point.kind() == SurfacePoint::Kind::edge) {
    from = (position(mesh_, point) - mesh_.position(start(step))).norm();
  }
  double rest = from + wanted;
  double passed = -from;
  // A closed crease is not followed round twice.
  for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
    const double length = mesh_.length(mesh_.halfedge(step.edge));
    const Step after = rest > length ? next(step) : Step{};
    if (!after.edge.valid()) break;
    rest -= length;
    passed += length;
    step = after;
  }
  const double last = std::min(rest, mesh_.length(mesh_.halfedge(step.edge)));
  trace.points.push_back(at(step, last));
  trace.length = passed + last;
  trace.complete = trace.length >= wanted;
  trace.direction = end_direction(trace.points.back(), step);
  return trace;
}

/// Of a line that has come along the step. At its end, which may be a corner, straight on from the edge.
Vec2 CreaseNetwork::end_direction(const SurfacePoint& point, const Step& step) const {
  if (point.kind() == SurfacePoint::Kind::edge) return direction(point, step);
  return -direction(point, {step.edge, !step.forwards});
}

}  // namespace gvd
