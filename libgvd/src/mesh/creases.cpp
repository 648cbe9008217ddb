// Creases: the edges whose faces meet at an angle, their connected groups, and the curves that they form.
//
// A curve runs from corner to corner and holds each of its creases once. Corners where a crease only turns are told
// from zigzags, as in the boundary of a scan, by the chords over several edges on both sides.
#include "mesh/creases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/angles.hpp"
#include "base/union_find.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Number of edges on both sides of a corner, over which the crease turns, too. The boundary of a scan goes to and fro
/// at every vertex.
constexpr int kChordEdges = 5;

/// Least length of a group of creases that an even spacing gives three generators, in spacings.
constexpr double kLeastGroup = 3;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Unit normal of a face, or 0 where the face has no area.
Vec3 crease_normal(const Mesh& mesh, FaceId f) {
  if (!(mesh.area(f) > 0)) return Vec3::Zero();
  const auto& [a, b, c] = mesh.vertices(f);
  return (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).stableNormalized();
}

}  // namespace

CreaseTest::CreaseTest(double angle) : bound_(radians(angle)) {}

bool CreaseTest::operator()(const Vec3& here, const Vec3& there) const {
  return angle_between(here, there) > bound_;  // 0 where one is 0
}

void check_crease_angle(double angle) {
  if (!(angle > 0 && angle <= 180)) {
    throw Error(ErrorCode::invalid_option, "the angle of creases must be above 0 and at most 180 degrees");
  }
}

std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options) {
  check_crease_angle(options.angle);
  const CreaseTest meet_at_crease(options.angle);
  const auto normal = [&](HalfedgeId h) { return crease_normal(mesh, Mesh::face(h)); };
  std::vector<EdgeId> creases;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (twin.valid() ? meet_at_crease(normal(h), normal(twin)) : options.with_boundary) creases.push_back(e);
  }
  return creases;
}

double total_length(const Mesh& mesh, const std::vector<EdgeId>& edges) {
  double length = 0;
  for (const EdgeId e : edges) length += mesh.length(e);
  return length;
}

bool CreaseGroup::is_long(double spacing) const { return length >= kLeastGroup * spacing; }

std::vector<CreaseGroup> group_creases(const Mesh& mesh, const std::vector<EdgeId>& creases) {
  UnionFind sets(mesh.vertex_count());
  IdVector<VertexId, char> has_crease(mesh.vertex_count(), 0);
  IdVector<VertexId, std::int32_t> group_of(mesh.vertex_count(), -1);
  for (const EdgeId e : creases) {
    const VertexId from = mesh.from(mesh.halfedge(e)), to = mesh.to(mesh.halfedge(e));
    sets.unite(from.value(), to.value());
    has_crease[from] = has_crease[to] = 1;
  }
  std::vector<CreaseGroup> groups;
  for (const VertexId v : mesh.vertices()) {
    if (!has_crease[v]) continue;
    const VertexId first(sets.find(v.value()));
    if (first == v) {
      group_of[v] = std::int32_t(groups.size());
      groups.emplace_back();
    }
    group_of[v] = group_of[first];
    CreaseGroup& group = groups[group_of[v]];
    group.vertices.push_back(v);
  }
  for (const EdgeId e : creases) {
    CreaseGroup& group = groups[group_of[mesh.from(mesh.halfedge(e))]];
    group.edges.push_back(e);
    group.length += mesh.length(e);
  }
  return groups;
}

std::vector<EdgeId> keep_long(const std::vector<CreaseGroup>& groups, double spacing) {
  std::vector<EdgeId> kept;
  for (const CreaseGroup& group : groups) {
    if (group.is_long(spacing)) kept.insert(kept.end(), group.edges.begin(), group.edges.end());
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

CreaseNetwork::CreaseNetwork(const Mesh& mesh, const std::vector<EdgeId>& creases, double corner_distance)
    : mesh_(mesh), is_crease_(mesh.edge_count(), false), leaving_(mesh.vertex_count()) {
  for (const EdgeId e : creases) {
    is_crease_[e] = true;
    for (const bool forwards : {true, false}) leaving_[start({e, forwards})].push_back({e, forwards});
  }
  const double least_cosine = std::cos(radians(kCornerTurn));
  for (const VertexId v : mesh.vertices()) {
    is_corner_.push_back(leaving_[v].size() != 2 ||
                         (turn_cosine(v, 1) < least_cosine && turn_cosine(v, kChordEdges) < least_cosine));
  }
  if (corner_distance > 0) thin_corners(corner_distance);
}

/// The cosine of the turn at a vertex with two creases, between the chords of so many edges on both sides. A chord ends
/// earlier where its curve does.
double CreaseNetwork::turn_cosine(VertexId v, int edges) const {
  const auto chord = [&](Step step) -> Vec3 {
    for (int i = 1; i < edges && leaving_[end(step)].size() == 2; ++i) step = onward(step);
    return mesh_.position(end(step)) - mesh_.position(v);
  };
  const Vec3 a = chord(leaving_[v][0]), b = chord(leaving_[v][1]);
  return -a.dot(b) / std::max(a.norm() * b.norm(), std::numeric_limits<double>::min());
}

/// Keeps corners where a crease only turns, the sharpest first, if they are this far from all that are kept.
void CreaseNetwork::thin_corners(double distance) {
  std::vector<std::pair<double, VertexId>> turns;
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
      passed += mesh_.length(step.edge);
      const VertexId to = end(step);
      if (!(passed < distance)) break;
      if (kept[to]) return true;
      if (leaving_[to].size() != 2 || to == v) break;
      step = onward(step);
    }
  }
  return false;
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

std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double corner_distance) {
  return trace_curves(mesh, CreaseNetwork(mesh, creases, corner_distance), creases);
}

SurfacePoint point_on_edge(const Mesh& mesh, EdgeId edge, VertexId start, double distance) {
  const HalfedgeId h = mesh.halfedge(edge);
  const bool forwards = mesh.from(h) == start;
  if (distance <= 0) return vertex_point(mesh, start);
  if (distance >= mesh.length(h)) return vertex_point(mesh, forwards ? mesh.to(h) : mesh.from(h));
  return edge_point(h, forwards ? distance / mesh.length(h) : 1 - distance / mesh.length(h));
}

std::vector<SurfacePoint> points_on_curve(const Mesh& mesh, const CreaseCurve& curve, const std::vector<double>& at) {
  std::vector<SurfacePoint> points;
  double passed = 0;
  std::size_t i = 0;
  for (const double length : at) {
    for (; i + 1 < curve.edges.size() && passed + mesh.length(curve.edges[i]) < length; ++i) {
      passed += mesh.length(curve.edges[i]);
    }
    points.push_back(point_on_edge(mesh, curve.edges[i], curve.vertices[i], length - passed));
  }
  return points;
}

}  // namespace gvd
