// Geodesic polar coordinates over a patch: a march in the order of distance, then sweeps until the values converge.
#include "gvd/log_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "geodesic/field/face_layout.hpp"
#include "geodesic/tracing/polar_update.hpp"
#include "geodesic/tracing/tangent_fan.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "gvd/vec.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Largest number of sweeps after the march. On a flat patch every sweep finishes one more link of a chain of obtuse
/// triangles; on scans nothing changes after three to five sweeps.
constexpr int kMaxSweeps = 8;

/// Relative changes of a distance below this are rounding.
constexpr double kConverged = 1e-12;

/// The triangle of h's face on h as its base: A = from(h), B = to(h), D opposite.
UpdateTriangle triangle_on(const Mesh& mesh, HalfedgeId h) {
  const FaceShape& s = mesh.shape(Mesh::face(h));
  const auto i = static_cast<std::size_t>(Mesh::corner(h));
  return make_update_triangle(s.length[i], s.length[(i + 2) % 3], s.length[(i + 1) % 3], s.twice_area);
}

/// Polar step to the corner opposite to the base of t. An unknown distance is infinite; at most one of the two is.
PolarStep step_from_known(const UpdateTriangle& t, double distance_a, double distance_b) {
  if (distance_a < kInfinity && distance_b < kInfinity) return step_to_corner(t, distance_a, distance_b);
  const auto kind = distance_a < kInfinity ? PolarStep::Kind::along_a : PolarStep::Kind::along_b;
  return {update_along_edges(t, distance_a, distance_b), kind};
}

}  // namespace

LogMapSolver::LogMapSolver(const Mesh& mesh)
    : mesh_(mesh),
      face_stamp_(static_cast<std::size_t>(mesh.face_count()), 0),
      vertex_stamp_(static_cast<std::size_t>(mesh.vertex_count()), 0),
      state_(static_cast<std::size_t>(mesh.vertex_count())) {}

LogMap LogMapSolver::compute(const SurfacePoint& origin, const std::vector<FaceId>& faces) {
  check_origin(origin);
  ++call_;
  queue_.clear();
  order_.clear();
  open_patch(origin, faces);
  start(origin);
  march();
  converge();
  return collect(faces);
}

void LogMapSolver::check_origin(const SurfacePoint& origin) const {
  if (origin.face.valid() && origin.face.value() < mesh_.face_count()) return;
  throw Error(ErrorCode::precondition,
              fmt::format("the origin of a log map lies in face {}: the mesh has {}", origin.face.value(),
                          counted(mesh_.face_count(), "face", "faces")),
              origin.face.value());
}

LogMap LogMapSolver::collect(const std::vector<FaceId>& faces) const {
  LogMap map;
  map.corners.reserve(faces.size());
  for (const FaceId f : faces) {
    std::array<Vec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Polar& p = state_[mesh_.vertices(f)[i]].value;
      const bool reached = p.distance < kInfinity;
      corners[i] = reached ? Vec2(p.distance * unit_vector(p.angle)) : Vec2(kInfinity, kInfinity);
      map.complete = map.complete && reached;
    }
    map.corners.push_back(corners);
  }
  return map;
}

void LogMapSolver::open_patch(const SurfacePoint& origin, const std::vector<FaceId>& faces) {
  for (const VertexId v : mesh_.vertices(origin.face)) open_faces_round(v);
  for (const FaceId f : faces) {
    for (const VertexId v : mesh_.vertices(f)) open_faces_round(v);
  }
}

/// Until the march, `accepted` marks the vertices whose faces are all in the patch.
void LogMapSolver::open_faces_round(VertexId v) {
  if (vertex_stamp_[v] == call_ && state_[v].accepted) return;
  for_each_outgoing(mesh_, v, [&](HalfedgeId h) { open_face(Mesh::face(h)); });
  state_[v].accepted = true;
}

void LogMapSolver::open_face(FaceId f) {
  if (is_in_patch(f)) return;
  face_stamp_[f] = call_;
  for (const VertexId v : mesh_.vertices(f)) {
    if (vertex_stamp_[v] == call_) continue;
    vertex_stamp_[v] = call_;
    state_[v] = {{kInfinity, 0}, {kInfinity, 0}, false, false};
    order_.push_back(v);
  }
}

/// Sets the direct values: segments in the faces round the origin.
void LogMapSolver::start(const SurfacePoint& origin) {
  for (const VertexId v : order_) state_[v].accepted = false;
  order_.clear();
  const TangentFan fan(mesh_, origin);
  for (const TangentSector& sector : fan.sectors()) {
    const FaceLayout layout(mesh_, sector.point.face);
    const Vec2 from = layout.at(sector.point.bary);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = mesh_.vertices(sector.point.face)[i];
      const double distance = sector.point.bary[i] == 1 ? 0 : (layout.corner[i] - from).norm();
      if (!(distance < state_[v].direct.distance)) continue;
      state_[v].direct = {distance, distance > 0 ? fan.angle(sector.point.face, layout.corner[i] - from) : 0};
      offer(v, distance);
    }
  }
}

void LogMapSolver::offer(VertexId v, double distance) {
  if (!(distance < state_[v].value.distance)) return;
  state_[v].value.distance = distance;
  queue_.emplace_back(distance, v);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

/// Accepts the vertices in the order of their distance, each once.
void LogMapSolver::march() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const VertexId v = queue_.back().second;
    queue_.pop_back();
    if (state_[v].accepted) continue;
    state_[v].value = compute_value(v, true);
    state_[v].accepted = true;
    order_.push_back(v);
    offer_to_neighbours(v);
  }
}

/// Offers the neighbours of an accepted vertex the distances that follow from its own.
void LogMapSolver::offer_to_neighbours(VertexId v) {
  for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
    if (!is_in_patch(Mesh::face(h))) return;
    offer_through(h);
    offer_through(Mesh::previous(h));
  });
}

void LogMapSolver::offer_through(HalfedgeId base) {
  const VertexId d = mesh_.opposite(base);
  if (state_[d].accepted) return;
  const auto distance = [&](VertexId x) { return state_[x].accepted ? state_[x].value.distance : kInfinity; };
  const double distance_a = distance(mesh_.from(base)), distance_b = distance(mesh_.to(base));
  offer(d, step_from_known(triangle_on(mesh_, base), distance_a, distance_b).distance);
}

/// The shortest path to v through its faces in the patch.
LogMapSolver::Polar LogMapSolver::compute_value(VertexId v, bool accepted_only) const {
  const Polar direct = state_[v].direct;
  const auto known = [&](VertexId x) {
    const bool usable = !accepted_only || state_[x].accepted;
    return usable ? state_[x].value : Polar{kInfinity, 0};
  };
  PolarStep shortest;
  shortest.distance = direct.distance;
  HalfedgeId shortest_base;
  for_each_outgoing(mesh_, v, [&](HalfedgeId leaving) {
    if (!is_in_patch(Mesh::face(leaving))) return;
    const HalfedgeId base = Mesh::next(leaving);
    const Polar a = known(mesh_.from(base)), b = known(mesh_.to(base));
    // A lower bound of the distance on the base, and so of every path through it.
    const double nearest = 0.5 * (a.distance + b.distance - mesh_.length(base));
    if (!(std::min({a.distance, b.distance, nearest}) < shortest.distance)) return;
    const PolarStep step = step_from_known(triangle_on(mesh_, base), a.distance, b.distance);
    if (!(step.distance < shortest.distance * (1 - kConverged))) return;  // of equals the direct one, then the first
    shortest = step;
    shortest_base = base;
  });
  if (!shortest_base.valid()) return direct;
  const double angle_a = state_[mesh_.from(shortest_base)].value.angle;
  const double angle_b = state_[mesh_.to(shortest_base)].value.angle;
  return {shortest.distance, polar_angle(triangle_on(mesh_, shortest_base), shortest, angle_a, angle_b)};
}

/// Recomputes the values in the order of distance until they converge. A value can change only if a neighbour's has
/// changed.
void LogMapSolver::converge() {
  for (const VertexId v : order_) state_[v].stale = true;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool changed = false;
    for (const VertexId v : order_) {
      if (!state_[v].stale) continue;
      state_[v].stale = false;
      const Polar before = state_[v].value, after = compute_value(v, false);
      if (after.distance == before.distance && after.angle == before.angle) continue;
      state_[v].value = after;
      for_each_neighbour(mesh_, v, [&](VertexId neighbour, HalfedgeId) { state_[neighbour].stale = true; });
      changed = changed || std::abs(after.distance - before.distance) > kConverged * before.distance;
    }
    if (!changed) return;
  }
}

LogMap compute_log_map(const Mesh& mesh, const SurfacePoint& origin) {
  std::vector<FaceId> faces;
  faces.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.emplace_back(f);
  return LogMapSolver(mesh).compute(origin, faces);
}

}  // namespace gvd
