// Features of a mesh: its creases, the curves that they form, generators on them, and where generators may go.
//
// A crease is an edge whose faces meet at an angle. Curves run from corner to corner and hold each crease once; closed
// ones come last. Generators lie on all corners and are evenly spaced by length between them, so that no cell reaches
// over a corner. Points are snapped to vertices before edges: a point that was written with few digits is on the same
// vertex again.
//
// A crease is walked edge by edge. Tangent vectors at its points have the frame of geodesic_tracing.hpp, so that a path
// along a crease has a length and a direction at its end as a geodesic has. A corner ends every curve: there a
// generator stays. Corners where a crease only turns are told from zigzags, as in the boundary of a scan, by the chords
// over several edges on both sides. Every path ends on the crease that it began on.
#include "gvd/features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/least.hpp"
#include "constraints.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// Number of edges on both sides of a corner, over which the crease turns, too. The boundary of a scan goes to and fro
/// at every vertex.
constexpr int kChordEdges = 5;

/// The point of an edge at a distance from one of its ends, mesh units, which is limited to the edge.
SurfacePoint point_on_edge(const Mesh& mesh, EdgeId edge, VertexId start, double distance) {
  const HalfedgeId h = mesh.halfedge(edge);
  const bool forwards = mesh.from(h) == start;
  if (distance <= 0) return vertex_point(mesh, start);
  if (distance >= mesh.length(h)) return vertex_point(mesh, forwards ? mesh.to(h) : mesh.from(h));
  return edge_point(h, forwards ? distance / mesh.length(h) : 1 - distance / mesh.length(h));
}

/// Unit normal of a face. It is scaled before it is normalized, unlike `face_normal`: squares of tiny sides may vanish.
Vec3 stable_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).stableNormalized();
}

/// Parts a crease network into curves, each edge once.
class CreaseTracer {
 public:
  CreaseTracer(const Mesh& mesh, const CreaseNetwork& network)
      : mesh_(mesh), network_(network), done_(mesh.edge_count(), false) {}

  std::vector<CreaseCurve> run(const std::vector<EdgeId>& creases) {
    for (const VertexId v : mesh_.vertices()) {
      if (!network_.is_corner(v)) continue;
      for (const CreaseNetwork::Step& step : network_.leaving(v)) trace(step);
    }
    for (const EdgeId e : creases) trace({e, true});  // the closed ones are left
    return std::move(curves_);
  }

 private:
  void trace(const CreaseNetwork::Step& first) {
    if (done_[first.edge]) return;
    CreaseCurve curve;
    curve.vertices.push_back(network_.start(first));
    CreaseNetwork::Step step = first;
    for (; step.edge.valid() && !done_[step.edge]; step = network_.next(step)) {
      done_[step.edge] = true;
      curve.edges.push_back(step.edge);
      curve.vertices.push_back(network_.end(step));
    }
    curve.closed = step.edge.valid();
    curves_.push_back(std::move(curve));
  }

  const Mesh& mesh_;
  const CreaseNetwork& network_;
  IdVector<EdgeId, bool> done_;
  std::vector<CreaseCurve> curves_;
};

double length_of(const Mesh& mesh, const CreaseCurve& curve) {
  double length = 0;
  for (const EdgeId e : curve.edges) length += mesh.length(e);
  return length;
}

/// Places generators between the ends of a curve.
void place_along(const Mesh& mesh, const CreaseCurve& curve, double spacing, FeatureGenerators& placed) {
  const double length = length_of(mesh, curve);
  const bool is_loop = curve.vertices.front() == curve.vertices.back();  // a coarse one has three edges at least
  const double parts = std::max(std::round(length / spacing), is_loop ? 3.0 : 1.0);
  double passed = 0;
  std::size_t i = 0;
  const auto edge_length = [&] { return mesh.length(curve.edges[i]); };
  for (double k = curve.closed ? 0 : 1; k < parts; ++k) {
    const double at = length * k / parts;
    while (i + 1 < curve.edges.size() && passed + edge_length() < at) passed += edge_length(), ++i;
    placed.points.push_back(point_on_curve(mesh, curve, i, at - passed));
    placed.freedom.push_back(Freedom::on_crease);
  }
}

/// The nearest vertex of a crease in the faces of a point, within a distance; invalid if there is none.
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

/// The nearest point on the creases in the faces of a point, within a distance; else the point itself.
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
  if (of(generator) == Freedom::on_crease) return network_->project(point, tangent);
  return is_free(generator) ? project_to_surface(mesh, point, tangent) : Vec2(0, 0);
}

GeodesicTrace GeneratorConstraints::move(const Mesh& mesh, std::size_t generator, const SurfacePoint& point,
                                         const Vec2& step) const {
  if (of(generator) == Freedom::on_crease) return network_->follow(point, network_->project(point, step));
  return trace_geodesic(mesh, point, is_free(generator) ? step : Vec2(0, 0));
}

std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options) {
  if (!(options.angle > 0 && options.angle <= 180)) {
    throw Error(ErrorCode::invalid_option, "the angle of creases must be above 0 and at most 180 degrees");
  }
  const double least_cosine = options.angle == 180 ? -2 : std::cos(options.angle * std::numbers::pi / 180);
  std::vector<EdgeId> creases;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid()) {
      if (options.with_boundary) creases.push_back(e);
      continue;
    }
    const Vec3 here = stable_normal(mesh, Mesh::face(h)), there = stable_normal(mesh, Mesh::face(twin));
    const bool has_area = mesh.area(Mesh::face(h)) > 0 && mesh.area(Mesh::face(twin)) > 0;
    if (has_area && here.dot(there) < least_cosine) creases.push_back(e);
  }
  return creases;
}

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

SurfacePoint point_on_curve(const Mesh& mesh, const CreaseCurve& curve, std::size_t edge, double distance) {
  return point_on_edge(mesh, curve.edges[edge], curve.vertices[edge], distance);
}

std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double corner_distance) {
  CreaseNetwork network(mesh, creases);
  network.thin_corners(corner_distance);
  return CreaseTracer(mesh, network).run(creases);
}

FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                   double corner_distance) {
  if (!(spacing > 0)) throw Error(ErrorCode::invalid_option, "the spacing of generators on creases must be above 0");
  CreaseNetwork network(mesh, creases);
  network.thin_corners(corner_distance);
  FeatureGenerators placed;
  for (const VertexId v : mesh.vertices()) {
    if (network.leaving(v).empty() || !network.is_corner(v)) continue;
    placed.points.push_back(vertex_point(mesh, v));
    placed.freedom.push_back(Freedom::fixed);
  }
  for (const CreaseCurve& curve : CreaseTracer(mesh, network).run(creases)) place_along(mesh, curve, spacing, placed);
  return placed;
}

}  // namespace gvd
