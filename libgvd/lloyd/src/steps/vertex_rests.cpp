#include "vertex_rests.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "geodesic/tracing/tangent_fan.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "integrals/cell_faces.hpp"

namespace gvd {
namespace {

/// Bounds of the distance at which the energy is tried, in mean cell radii: rounding would decide below, and the rest
/// of the cell above.
constexpr double kLeastRadius = 1e-5, kLargestRadius = 1e-2;

/// Directions in which the energy round a vertex is tried.
constexpr int kDirections = 12;

/// Largest distance of a generator from the vertex where it goes to rest, in mean cell radii. From farther away the
/// vertex is reached by steps as usual, without the cost of the tests.
constexpr double kReach = 0.1;

/// Whether the energy can have a minimum with a kink at a vertex: paths bend there. Elsewhere no test is needed.
bool can_rest_at(const Mesh& mesh, const SurfacePoint& vertex) {
  const TangentFan fan(mesh, vertex);
  return !fan.closed() || fan.scale() < 1;
}

/// Whether no step of the length `radius` from the vertex lowers the energy.
bool is_lowest(const Mesh& mesh, const SurfacePoint& vertex, double radius,
               const std::function<double(const SurfacePoint&)>& energy) {
  const double at_vertex = energy(vertex);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDirections;
    const Vec2 step = radius * Vec2(std::cos(angle), std::sin(angle));
    if (energy(trace_geodesic(mesh, vertex, step).points.back()) < at_vertex) return false;
  }
  return true;
}

/// The corner of the generator's face that lies on the way to the centroid within 45 degrees, and within `reach`.
std::optional<VertexId> find_vertex_ahead(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way,
                                          double reach) {
  if (generator.kind() == SurfacePoint::Kind::vertex) return std::nullopt;
  const Vec3 from = position(mesh, generator);
  for (const VertexId v : mesh.vertices(generator.face)) {
    const Vec3 to_vertex = mesh.position(v) - from;
    const double distance = to_vertex.norm();
    if (distance > std::min(reach, way.norm())) continue;
    const SurfacePoint end = trace_geodesic(mesh, generator, distance * way.normalized()).points.back();
    if ((position(mesh, end) - from).dot(to_vertex) >= std::sqrt(0.5) * distance * distance) return v;
  }
  return std::nullopt;
}

}  // namespace

double rest_radius(const RelaxationState& state, double move_tolerance) {
  return std::clamp(move_tolerance, kLeastRadius, kLargestRadius) * state.mean_cell_radius;
}

void mark_rests(const Mesh& mesh, double radius, CellIntegrals& integrals, RelaxationState& state) {
  const CellFaces cells(state.diagram);
  state.residual = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const auto energy = [&](const SurfacePoint& p) {
      return integrals.compute(p, cells.of(GeneratorId(static_cast<std::int64_t>(i)))).energy;
    };
    const bool is_at_vertex = state.generators[i].kind() == SurfacePoint::Kind::vertex;
    const bool has_way = state.to_centroids[i] != Vec2::Zero();  // fixed generators have none, and need no test
    state.is_resting[i] = is_at_vertex && has_way && can_rest_at(mesh, state.generators[i]) &&
                          is_lowest(mesh, state.generators[i], radius, energy);
    if (state.is_resting[i]) state.to_centroids[i] = Vec2::Zero();
    state.residual = std::max(state.residual, state.to_centroids[i].norm());
  }
}

std::vector<Rest> find_rests(const Mesh& mesh, const RelaxationState& state, double radius, CellIntegrals& integrals) {
  const CellFaces cells(state.diagram);
  std::vector<Rest> rests;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const GeneratorId g(static_cast<std::int64_t>(i));
    if (state.to_centroids[i].norm() <= radius) continue;
    const std::optional<VertexId> v =
        find_vertex_ahead(mesh, state.generators[i], state.to_centroids[i], kReach * state.mean_cell_radius);
    if (!v || !can_rest_at(mesh, vertex_point(mesh, *v))) continue;
    const auto energy = [&](const SurfacePoint& p) { return integrals.compute(p, cells.of(g)).energy; };
    const SurfacePoint vertex = vertex_point(mesh, *v);
    if (energy(vertex) < energy(state.generators[i]) && is_lowest(mesh, vertex, radius, energy))
      rests.push_back({i, *v});
  }
  return rests;
}

void move_to_rest(const Mesh& mesh, const Rest& rest, double gap, const std::vector<SurfacePoint>& from,
                  GeneratorMove& move) {
  const Vec3& vertex = mesh.position(rest.vertex);
  for (std::size_t i = 0; i < move.to.size(); ++i) {
    if (i != rest.generator && (position(mesh, move.to[i]) - vertex).norm() <= gap) return;
  }
  move.to[rest.generator] = vertex_point(mesh, rest.vertex);
  move.length[rest.generator] = (position(mesh, from[rest.generator]) - vertex).norm();
  move.step[rest.generator] = Vec2::Zero();
  move.turns[rest.generator] = Turn(1, 0);
}

}  // namespace gvd
