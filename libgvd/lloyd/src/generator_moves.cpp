// Moves generators along geodesics and creases, and from cells with little energy to places far from all generators.
//
// A geodesic keeps its direction, so parallel transport takes the step at its start to the step at its end. Two
// generators at the same place would have no diagram, so moves after which generators collide are undone until none
// collide. A point that is back at its start stays there, so this ends. Colliding generators are found by a sweep along
// x, in the order of their ids if coordinates are equal.
// In the best diagrams all cells have about the same area and energy. Relaxation evens this out only slowly, because
// generators have to pass each other. Relocations are planned by estimates of the energy that a generator saves at a
// distance from all others, and of the energy that giving up its old cell costs. Adjacent cells are not given up
// together, so that no hole arises. Distances to places already taken are computed only when a place reaches the top of
// its heap.
#include "generator_moves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "base/lazy_max_heap.hpp"
#include "gvd/geodesic_tracing.hpp"

namespace gvd {
namespace {

/// The least distance between two generators, as a fraction of the mean cell radius. It is a thousand times less than
/// in any relaxed diagram.
constexpr double kGap = 1e-6;

/// The least distance between two generators, in distances at which two points coincide. It matters on surfaces with
/// hardly any area.
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

/// The points that have moved and are within `gap` of another point, ascending. Sorts `order` along x.
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

/// For this many iterations, a generator is not sent again to a vertex where it did not rest.
constexpr std::size_t kRestPause = 10;

/// A generator at distance D from all others saves about this factor times D^4, because a disc of radius D / 2 gets a
/// generator at its centre instead of one at a distance of about 3/4 D on average.
constexpr double kSplitGain = 0.34;

/// The estimated cost of giving up a cell, in energies of the cell: twice the measured 2. With too small a factor,
/// plans promise too much.
constexpr double kRemovalCost = 4;

/// Largest total size of adjacent cells that are given up, in mean sizes.
constexpr double kLargestHole = 0.5;

/// The least distance between a relocated generator and the nearest other one, in radii of a disc of the mean size.
/// Relaxed cells reach up to 1.3, but then no cell is poor enough to be given up.
constexpr double kLeastDistance = 1.2;

/// The size of a cell, which equals its area if the density is 1. In the best diagrams, the integral of the root of the
/// density is the same for all cells.
double size_of(const CellMoments& moments) { return std::sqrt(moments.mass * moments.area); }

/// The component of each generator, and the mean size of the cells of each component.
struct Components {
  std::vector<std::size_t> of;
  std::vector<double> mean_size;
};

Components find_components(const IdVector<FaceId, std::int32_t>& components, const RelaxationState& state) {
  Components found;
  std::vector<double> cells;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const int component = components[state.generators[i].face];
    found.of.push_back(component);
    cells.resize(std::max<std::size_t>(cells.size(), component + 1));
    found.mean_size.resize(cells.size());
    cells[component] += 1;
    found.mean_size[component] += size_of(state.moments[GeneratorId(i)]);
  }
  for (std::size_t c = 0; c < cells.size(); ++c) found.mean_size[c] /= std::max(1.0, cells[c]);
  return found;
}

/// Chooses the cells to give up, by ascending energy.
class PoorCells {
 public:
  PoorCells(const RelaxationState& state, const Components& components)
      : moments_(state.moments),
        components_(components),
        order_(moments_.ids().begin(), moments_.ids().end()),
        hole_(moments_.size(), 0),
        neighbours_(moments_.size()) {
    for (const auto& [left, right] : neighbouring_cells(state.geometry.segments)) {
      neighbours_[left].push_back(right);
      neighbours_[right].push_back(left);
    }
    std::ranges::sort(order_, {}, [&](GeneratorId g) { return std::pair(moments_[g].energy, g); });
  }

  /// The next cell that leaves no hole that is too large; invalid if there is none.
  GeneratorId next() {
    while (next_ < order_.size()) {
      const GeneratorId g = order_[next_++];
      if (!(hole_with(g) > kLargestHole * components_.mean_size[components_.of[g.index()]])) return g;
    }
    return GeneratorId();
  }
  void give_up(GeneratorId g) {
    const double hole = hole_with(g);
    hole_[g] = hole;
    for (const GeneratorId n : neighbours_[g]) hole_[n] = hole_[n] > 0 ? hole : 0;
  }

 private:
  /// The size of the hole around a cell if this cell is given up, too.
  double hole_with(GeneratorId g) const {
    double hole = size_of(moments_[g]);
    for (const GeneratorId n : neighbours_[g]) hole += hole_[n];
    return hole;
  }

  const IdVector<GeneratorId, CellMoments>& moments_;
  const Components& components_;
  std::vector<GeneratorId> order_;
  IdVector<GeneratorId, double> hole_;  // total size of the adjacent cells given up together; 0 for a cell that stays
  IdVector<GeneratorId, std::vector<GeneratorId>> neighbours_;
  std::size_t next_ = 0;
};

/// Chooses vertices far from all generators. Distances are scaled by the fourth root of the density, like the radii of
/// the best cells.
class FarVertices {
 public:
  /// A vertex, and its scaled distance to the nearest generator.
  struct Place {
    double distance;
    VertexId vertex;
    std::size_t compared = 0;  // how many of the taken places it was compared with
  };

  /// `face_component`: the component of every face. Vertices too near to a generator are left out.
  FarVertices(const Mesh& mesh, const Density& density, const RelaxationState& state,
              const IdVector<FaceId, std::int32_t>& face_component, const Components& components)
      : mesh_(mesh), density_(density), places_(components.mean_size.size()) {
    for (const double size : components.mean_size) {
      least_distance_.push_back(kLeastDistance * std::sqrt(size / std::numbers::pi));
    }
    for (const VertexId v : mesh.vertices()) {
      if (!mesh.halfedge(v).valid() || !std::isfinite(state.geometry.vertex_distance[v])) continue;
      const double distance = scale(v) * state.geometry.vertex_distance[v];
      const int component = face_component[vertex_point(mesh, v).face];
      if (distance > least_distance_[component]) places_[component].push_back({distance, v});
    }
    for (const std::vector<Place>& places : places_) {
      heaps_.emplace_back(std::ssize(places), [&](int i) { return places[i].distance; });
    }
  }

  /// The farthest vertex of a component, if there is one. Only vertices at the top of the heap are compared with places
  /// already taken, and each place is compared only once.
  std::optional<Place> farthest(std::size_t component) {
    if (heaps_[component].empty()) return std::nullopt;
    std::vector<Place>& places = places_[component];
    const auto& top = heaps_[component].top([&](int i) { return compared_distance(places[i]); });
    return top.key > least_distance_[component] ? std::optional(places[top.id]) : std::nullopt;
  }
  void take(VertexId v) { taken_.push_back(mesh_.position(v)); }

 private:
  double scale(VertexId v) const {
    const SurfacePoint point = vertex_point(mesh_, v);
    return std::pow(density_.at(point.face, point.bary), 0.25);
  }
  double compared_distance(Place& place) const {
    const Vec3& at = mesh_.position(place.vertex);
    const double factor = scale(place.vertex);
    for (; place.compared < taken_.size(); ++place.compared) {
      place.distance = std::min(place.distance, factor * (taken_[place.compared] - at).norm());
    }
    return place.distance;
  }

  const Mesh& mesh_;
  const Density& density_;
  // For each component with generators.
  std::vector<double> least_distance_;
  std::vector<std::vector<Place>> places_;  // ascending by vertex
  std::vector<LazyMaxHeap<>> heaps_;        // indices into the places
  std::vector<Vec3> taken_;
};

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
                              const GeneratorConstraints& constraints, const Rests& rests) {
  const std::vector<SurfacePoint>& from = state.generators;
  GeneratorMove move;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!rests.empty() && rests[i]) {
      add_rest(mesh, from[i], *rests[i], move);
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

bool RefusedRests::note(std::size_t iterations, const RelaxationState& moved, Rests& rests) {
  bool is_any = false;
  refusals_.resize(rests.size());
  for (std::size_t i = 0; i < rests.size(); ++i) {
    if (!rests[i] || moved.is_resting[i] || moved.generators[i].kind() != SurfacePoint::Kind::vertex) continue;
    refusals_[i] = {rests[i], iterations + kRestPause};
    rests[i].reset();
    is_any = true;
  }
  return is_any;
}

Rests RefusedRests::allowed(std::size_t iterations, Rests rests) const {
  for (std::size_t i = 0; i < refusals_.size(); ++i) {
    if (rests[i] == refusals_[i].vertex && iterations < refusals_[i].end) rests[i].reset();
  }
  return rests;
}

std::vector<Relocation> plan_relocations(const Mesh& mesh, const Density& density, const RelaxationState& state,
                                         const GeneratorConstraints& constraints) {
  const IdVector<FaceId, std::int32_t> face_component = compute_face_components(mesh);
  const Components components = find_components(face_component, state);
  FarVertices places(mesh, density, state, face_component, components);
  PoorCells poor(state, components);
  std::vector<Relocation> plan;
  while (plan.size() + 1 < state.generators.size()) {
    const GeneratorId g = poor.next();
    if (!g.valid()) break;
    const std::size_t i = g.index();
    if (!constraints.is_free(i)) continue;
    const auto place = places.farthest(components.of[i]);
    if (!place) continue;
    const double gain = kSplitGain * std::pow(place->distance, 4) - kRemovalCost * state.moments[g].energy;
    if (!(gain > 0)) continue;
    plan.push_back({i, vertex_point(mesh, place->vertex), gain});
    places.take(place->vertex);
    poor.give_up(g);
  }
  return plan;
}

double total_gain(const std::vector<Relocation>& relocations) {
  double gain = 0;
  for (const Relocation& relocation : relocations) gain += relocation.gain;
  return gain;
}

GeneratorMove relocate_generators(const Mesh& mesh, const RelaxationState& state,
                                  const std::vector<Relocation>& relocations, std::size_t count) {
  GeneratorMove move;
  const std::size_t size = state.generators.size();
  move.to = state.generators;
  move.length.assign(size, 0);
  move.step.assign(size, Vec2::Zero());
  move.turns.assign(size, Turn(1, 0));
  for (const auto& [i, to, gain] : std::span(relocations).first(count)) {
    move.to[i] = to;
    move.length[i] = (position(mesh, move.to[i]) - position(mesh, state.generators[i])).norm();
  }
  move.relocated = static_cast<std::int32_t>(count);
  return move;
}

}  // namespace gvd
