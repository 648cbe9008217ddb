// The creases of a mesh as curves, and the ways along them.
//
// A crease is walked edge by edge. Tangent vectors at its points have the frame of geodesic_tracing.hpp, so that a path
// along a crease has a length and a direction at its end as a geodesic has. A corner ends every curve: there a
// generator stays. Corners where a crease only turns are told from zigzags, as in the boundary of a scan, by the chords
// over several edges on both sides. Every path ends on the crease that it began on.
#include "crease_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"

namespace gvd {
namespace {

/// Number of edges on both sides of a corner, over which the crease turns, too. The boundary of a scan goes to and fro
/// at every vertex.
constexpr int kChordEdges = 5;

}  // namespace

SurfacePoint point_on_edge(const Mesh& mesh, EdgeId edge, VertexId start, double distance) {
  const HalfedgeId h = mesh.halfedge(edge);
  const bool forwards = mesh.from(h) == start;
  if (distance <= 0) return vertex_point(mesh, start);
  if (distance >= mesh.length(h)) return vertex_point(mesh, forwards ? mesh.to(h) : mesh.from(h));
  return edge_point(h, forwards ? distance / mesh.length(h) : 1 - distance / mesh.length(h));
}

CreaseNetwork::CreaseNetwork(const Mesh& mesh, const std::vector<EdgeId>& creases)
    : mesh_(mesh), is_crease_(mesh.edge_count(), false), leaving_(mesh.vertex_count()) {
  for (const EdgeId e : creases) {
    is_crease_[e] = true;
    for (const bool forwards : {true, false}) leaving_[start({e, forwards})].push_back({e, forwards});
  }
  const double least_cosine = std::cos(kCornerTurn * std::numbers::pi / 180);
  for (const VertexId v : mesh.vertices()) {
    is_corner_.push_back(leaving_[v].size() != 2 ||
                         (turn_cosine(v, 1) < least_cosine && turn_cosine(v, kChordEdges) < least_cosine));
  }
}

double CreaseNetwork::turn_cosine(VertexId v, int edges) const {
  const Vec3 a = chord(leaving_[v][0], edges), b = chord(leaving_[v][1], edges);
  return -a.dot(b) / std::max(a.norm() * b.norm(), std::numeric_limits<double>::min());
}

/// The vector from the start of the step to the end of the last of so many edges, or to the end of the curve.
Vec3 CreaseNetwork::chord(Step step, int edges) const {
  const VertexId from = start(step);
  for (; edges > 1 && leaving_[end(step)].size() == 2; --edges) step = onward(step);
  return mesh_.position(end(step)) - mesh_.position(from);
}

void CreaseNetwork::thin_corners(double distance) {
  std::vector<std::pair<double, VertexId>> turns;  // the sharpest first
  IdVector<VertexId, bool> kept(leaving_.size(), false);
  for (const VertexId v : mesh_.vertices()) {
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
      passed += length(step);
      const VertexId to = end(step);
      if (!(passed < distance)) break;
      if (kept[to]) return true;
      if (leaving_[to].size() != 2 || to == v) break;
      step = onward(step);
    }
  }
  return false;
}

Vec2 CreaseNetwork::direction(const SurfacePoint& point, const Step& step) const {
  const HalfedgeId h = mesh_.halfedge(step.edge);
  if (point.kind() == SurfacePoint::Kind::edge) {
    const bool along = halfedge(point) == h;  // the tangent plane's x axis runs as the point's own halfedge
    return {along == step.forwards ? 1.0 : -1.0, 0};
  }
  const Vec2 side = FaceLayout(mesh_, Mesh::face(h)).side(Mesh::corner(h));
  return unit_vector(TangentFan(mesh_, point).angle(Mesh::face(h), step.forwards ? side : Vec2(-side)));
}

/// The direction of a line that has come along the step. At its end, which may be a corner, straight on from the edge.
Vec2 CreaseNetwork::end_direction(const SurfacePoint& point, const Step& step) const {
  if (point.kind() == SurfacePoint::Kind::edge) return direction(point, step);
  return -direction(point, {step.edge, !step.forwards});
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
  double from = 0;  // the way from the start of the first edge
  if (point.kind() == SurfacePoint::Kind::edge) {
    from = (position(mesh_, point) - mesh_.position(start(step))).norm();
  }
  double rest = from + wanted, passed = -from;
  // A closed crease is not followed round twice.
  for (int i = 0; i < mesh_.edge_count(); ++i) {
    const Step after = rest > length(step) ? next(step) : Step{};
    if (!after.edge.valid()) break;
    rest -= length(step);
    passed += length(step);
    step = after;
  }
  const double last = std::min(rest, length(step));
  trace.points.push_back(point_on_edge(mesh_, step.edge, start(step), last));
  trace.length = passed + last;
  trace.complete = trace.length >= wanted;
  trace.direction = end_direction(trace.points.back(), step);
  return trace;
}

std::vector<CreaseCurve> trace_curves(const Mesh& mesh, const CreaseNetwork& network,
                                      const std::vector<EdgeId>& creases) {
  IdVector<EdgeId, bool> done(mesh.edge_count(), false);
  std::vector<CreaseCurve> curves;
  const auto trace = [&](const CreaseNetwork::Step& first) {
    if (done[first.edge]) return;
    CreaseCurve curve;
    curve.vertices.push_back(network.start(first));
    CreaseNetwork::Step step = first;
    for (; step.edge.valid() && !done[step.edge]; step = network.next(step)) {
      done[step.edge] = true;
      curve.edges.push_back(step.edge);
      curve.vertices.push_back(network.end(step));
    }
    curve.closed = step.edge.valid();
    curves.push_back(std::move(curve));
  };
  for (const VertexId v : mesh.vertices()) {
    if (!network.is_corner(v)) continue;
    for (const CreaseNetwork::Step& step : network.leaving(v)) trace(step);
  }
  for (const EdgeId e : creases) trace({e, true});  // the closed ones are left
  return curves;
}

}  // namespace gvd
