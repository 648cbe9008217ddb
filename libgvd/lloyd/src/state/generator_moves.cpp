#include "generator_moves.hpp"

#include <algorithm>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/surface_point.hpp"
#include "keep_apart.hpp"

namespace gvd {
namespace {

/// Least distance between two generators, as a fraction of the mean cell radius. A thousand times less than in any
/// relaxed diagram.
constexpr double kGap = 1e-6;

/// The same in distances at which two points coincide. It counts on surfaces with hardly any area.
constexpr double kGapOfCoincident = 2;

void add_path(const GeodesicTrace& trace, const Vec2& step, GeneratorMove& move) {
  move.to.push_back(trace.points.back());
  move.length.push_back(trace.length);
  move.step.push_back(trace.length * trace.direction);
  move.turns.push_back(trace.length > 0 ? turn_between(step.normalized(), trace.direction) : Turn(1, 0));
}

void add_rest(const Mesh& mesh, const SurfacePoint& from, VertexId vertex, GeneratorMove& move) {
  move.to.push_back(vertex_point(mesh, vertex));
  move.length.push_back((mesh.position(vertex) - position(mesh, from)).norm());
  move.step.push_back(Vec2::Zero());
  move.turns.push_back(Turn(1, 0));
}

void undo_path(std::size_t i, GeneratorMove& move) {
  move.length[i] = 0;
  move.step[i] = Vec2::Zero();
  move.turns[i] = Turn(1, 0);
}

}  // namespace

GeneratorMove move_generators(const Mesh& mesh, const RelaxationState& state, const TangentField& steps,
                              const GeneratorConstraints& constraints, GoToRest rests) {
  const std::vector<SurfacePoint>& from = state.generators;
  GeneratorMove move;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (rests == GoToRest::yes && state.rest[i]) {
      add_rest(mesh, from[i], *state.rest[i], move);
    } else {
      add_path(constraints.move(mesh, i, from[i], steps[i]), steps[i], move);
    }
  }
  const double gap = std::max(kGap * state.mean_cell_radius, kGapOfCoincident * coincidence(mesh));
  move.held = keep_apart(mesh, from, gap, move.to);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (move.to[i] == from[i]) undo_path(i, move);
  }
  return move;
}

}  // namespace gvd
