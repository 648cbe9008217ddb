// Geodesic polar coordinates over a patch: a march by distance, and sweeps until the values stand.
#include "gvd/log_map.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "geodesic/field/face_layout.hpp"
#include "geodesic/tracing/polar_update.hpp"
#include "geodesic/tracing/tangent_fan.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Most sweeps after the march. On a flat patch every sweep settles one more link of a chain of obtuse triangles, and
/// on scans three to five sweeps leave nothing to change.
constexpr int kMostSweeps = 8;

/// A change below this part of a distance is rounding.
constexpr double kSettled = 1e-12;

/// The triangle of h's face on h as its base: A = from(h), B = to(h), D opposite.
UpdateTriangle triangle_on(const Mesh& mesh, HalfedgeId h) {
  const FaceShape& s = mesh.shape(Mesh::face(h));
  const auto i = static_cast<std::size_t>(Mesh::corner(h));
  return make_update_triangle(s.length[i], s.length[(i + 2) % 3], s.length[(i + 1) % 3], s.twice_area);
}

}  // namespace

LogMapSolver::LogMapSolver(const Mesh& mesh)
    : mesh_(mesh),
      face_stamp_(static_cast<std::size_t>(mesh.face_count()), 0),
      vertex_stamp_(static_cast<std::size_t>(mesh.vertex_count()), 0),
      state_(static_cast<std::size_t>(mesh.vertex_count())) {}

LogMap LogMapSolver::compute(const SurfacePoint& origin, const std::vector<FaceId>& faces) {
  if (!origin.face.valid() || origin.face.value() >= mesh_.face_count()) {
    throw Error(ErrorCode::precondition,
                "the origin of a log map lies in face " + std::to_string(origin.face.value()) + ": the mesh has " +
                    std::to_string(mesh_.face_count()) + " faces",
                origin.face.value());
  }
  ++turn_;
  queue_.clear();
  order_.clear();
  open_patch(origin, faces);
  start(origin);
  march();
  settle();
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
  for (const VertexId v : mesh_.vertices(origin.face)) open_round(v);
  for (const FaceId f : faces) {
    for (const VertexId v : mesh_.vertices(f)) open_round(v);
  }
}

void LogMapSolver::open_round(VertexId v) {
  if (vertex_stamp_[v] == turn_ && state_[v].accepted) return;  // opened before; `accepted` is the mark until the march
  for_each_halfedge(v, [&](HalfedgeId h) { open_face(Mesh::face(h)); });
  state_[v].accepted = true;
}

void LogMapSolver::open_face(FaceId f) {
  if (face_stamp_[f] == turn_) return;
  face_stamp_[f] = turn_;
  for (const VertexId v : mesh_.vertices(f)) {
    if (vertex_stamp_[v] == turn_) continue;
    vertex_stamp_[v] = turn_;
    state_[v] = {{kInfinity, 0}, {kInfinity, 0}, false, false};
    order_.push_back(v);
  }
}

/// Straight lines through the faces round the origin.
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

template <class Visit>
void LogMapSolver::for_each_halfedge(VertexId v, Visit visit) const {
  const HalfedgeId start = mesh_.halfedge(v);
  HalfedgeId h = start;
  do {
    visit(h);
    h = mesh_.twin(Mesh::previous(h));
  } while (h.valid() && h != start);
}

void LogMapSolver::offer(VertexId v, double distance) {
  if (!(distance < state_[v].value.distance)) return;
  state_[v].value.distance = distance;
  queue_.emplace_back(distance, v);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

/// Vertices in the order of their distance, each accepted once.
void LogMapSolver::march() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const VertexId v = queue_.back().second;
    queue_.pop_back();
    if (state_[v].accepted) continue;
    state_[v].value = best(v, true);
    state_[v].accepted = true;
    order_.push_back(v);
    spread(v);
  }
}

/// Offers the neighbours of an accepted vertex the distances that it makes possible.
void LogMapSolver::spread(VertexId v) {
  const auto offer_through = [&](HalfedgeId base) {
    const VertexId a = mesh_.from(base), b = mesh_.to(base), d = mesh_.opposite(base);
    if (state_[d].accepted) return;
    const auto distance = [&](VertexId x) { return state_[x].accepted ? state_[x].value.distance : kInfinity; };
    const UpdateTriangle t = triangle_on(mesh_, base);
    if (state_[a].accepted && state_[b].accepted) return offer(d, step_to_corner(t, distance(a), distance(b)).distance);
    offer(d, update_along_edges(t, distance(a), distance(b)));
  };
  for_each_halfedge(v, [&](HalfedgeId h) {
    if (face_stamp_[Mesh::face(h)] != turn_) return;
    offer_through(h);
    offer_through(Mesh::previous(h));
  });
}

/// The shortest way to v through its faces in the patch.
LogMapSolver::Polar LogMapSolver::best(VertexId v, bool accepted_only) const {
  const Polar direct = state_[v].direct;
  const auto known = [&](VertexId x) {
    const bool usable = !accepted_only || state_[x].accepted;
    return usable ? state_[x].value : Polar{kInfinity, 0};
  };
  PolarStep shortest;
  shortest.distance = direct.distance;
  HalfedgeId shortest_base;
  for_each_halfedge(v, [&](HalfedgeId leaving) {
    if (face_stamp_[Mesh::face(leaving)] != turn_) return;
    const HalfedgeId base = Mesh::next(leaving);
    const Polar a = known(mesh_.from(base)), b = known(mesh_.to(base));
    // No point of the base is nearer than this, and so no way through it is shorter: behind v that ends the matter.
    const double nearest = 0.5 * (a.distance + b.distance - mesh_.length(base));
    if (!(std::min({a.distance, b.distance, nearest}) < shortest.distance)) return;
    const UpdateTriangle t = triangle_on(mesh_, base);
    PolarStep step;
    if (a.distance < kInfinity && b.distance < kInfinity) {
      step = step_to_corner(t, a.distance, b.distance);
    } else {
      const bool from_a = a.distance < kInfinity;
      step = {update_along_edges(t, a.distance, b.distance),
              from_a ? PolarStep::Way::along_a : PolarStep::Way::along_b};
    }
    if (!(step.distance < shortest.distance * (1 - kSettled))) return;  // of equals, the direct one and the first
    shortest = step;
    shortest_base = base;
  });
  if (!shortest_base.valid()) return direct;
  const double angle_a = state_[mesh_.from(shortest_base)].value.angle;
  const double angle_b = state_[mesh_.to(shortest_base)].value.angle;
  return {shortest.distance, polar_angle(triangle_on(mesh_, shortest_base), shortest, angle_a, angle_b)};
}

/// Computes values again in the order of distance. Only those round a value that has changed can change.
void LogMapSolver::settle() {
  for (const VertexId v : order_) state_[v].stale = true;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool changed = false;
    for (const VertexId v : order_) {
      if (!state_[v].stale) continue;
      state_[v].stale = false;
      const Polar before = state_[v].value, after = best(v, false);
      if (after.distance == before.distance && after.angle == before.angle) continue;
      state_[v].value = after;
      for_each_halfedge(v, [&](HalfedgeId h) {
        state_[mesh_.to(h)].stale = true;
        state_[mesh_.opposite(h)].stale = true;
      });
      changed = changed || std::abs(after.distance - before.distance) > kSettled * before.distance;
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
