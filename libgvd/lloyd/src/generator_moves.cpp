// Moves of generators along geodesics and creases, with the parallel transport of their tangent planes.
//
// A geodesic keeps its direction, so that the turn of a tangent plane takes the step at its start to the step at its
// end. Two generators that meet would have no diagram: moves after which generators collide are undone, until none
// collides. A point that is back at its start stays there, so this ends. Generators are found by a sweep along x, in
// the order of their ids where coordinates are equal.
#include "generator_moves.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "gvd/geodesic_tracing.hpp"

namespace gvd {
namespace {

/// Least distance between two generators, as a fraction of the mean cell radius. A thousand times less than in any
/// relaxed diagram.
constexpr double kGap = 1e-6;

/// Least distance between two generators, in distances at which two points coincide. It counts on surfaces with hardly
/// any area.
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

/// The points that are free to move and within `gap` of another one, ascending. Sorts `order` along x.
std::vector<std::size_t> find_colliding(const std::vector<Vec3>& positions, const std::vector<char>& is_fixed,
                                        double gap, std::vector<std::size_t>& order) {
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(positions[i].x(), i); });
  std::vector<std::size_t> colliding;
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end(); ++b) {
      if (positions[*b].x() - positions[*a].x() > gap) break;
      if ((positions[*b] - positions[*a]).norm() > gap) continue;
      if (!is_fixed[*a]) colliding.push_back(*a);
      if (!is_fixed[*b]) colliding.push_back(*b);
    }
  }
  std::sort(colliding.begin(), colliding.end());
  colliding.erase(std::unique(colliding.begin(), colliding.end()), colliding.end());
  return colliding;
}

}  // namespace

std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to) {
  std::vector<std::size_t> order(to.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<char> is_at_start;
  std::vector<Vec3> positions;
  for (const std::size_t i : order) {
    is_at_start.push_back(to[i] == from[i]);
    positions.push_back(position(mesh, to[i]));
  }
  std::int32_t undone = 0;
  while (true) {
    const std::vector<std::size_t> colliding = find_colliding(positions, is_at_start, gap, order);
    if (colliding.empty()) return undone;
    for (const std::size_t i : colliding) {
      is_at_start[i] = 1;
      to[i] = from[i];
      positions[i] = position(mesh, from[i]);
      ++undone;
    }
  }
}

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
