#include "relocation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace gvd {
namespace {

/// A generator at distance D from all others saves about this factor of D^4: a disc of radius D / 2 comes from about
/// 3/4 D on the average to its centre.
constexpr double kSplitGain = 0.34;

/// A cell that is given up costs its neighbours about so many times its energy, before they have moved.
constexpr double kRemovalCost = 4;

/// Largest size of adjacent cells that are given up, in mean sizes.
constexpr double kLargestHole = 0.5;

/// Least distance between a relocated generator and the nearest one, in radii of a disc of the mean size. Relaxed cells
/// reach to 1.3.
constexpr double kLeastDistance = 1.5;

/// The area of a cell where the density is 1. In the best diagrams the integral of the root of the density is the same
/// for all cells.
double size_of(const CellMoments& moments) { return std::sqrt(moments.mass * moments.area); }

double mean_size(const RelaxationState& state) {
  double sum = 0;
  for (const CellMoments& moments : state.moments) sum += size_of(moments);
  return sum / static_cast<double>(state.generators.size());
}

/// Chooses the cells to give up, by ascending energy.
class PoorCells {
 public:
  explicit PoorCells(const RelaxationState& state)
      : state_(state),
        largest_hole_(kLargestHole * mean_size(state)),
        order_(state.generators.size()),
        hole_(state.generators.size(), 0),
        neighbours_(state.generators.size()) {
    for (const auto& [left, right] : neighbouring_cells(state.segments)) {
      neighbours_[left.index()].push_back(right);
      neighbours_[right.index()].push_back(left);
    }
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(energy(a), a) < std::pair(energy(b), b); });
  }

  /// The next cell without too large a hole round it; the number of cells if there is none.
  std::size_t take() {
    for (; next_ < order_.size(); ++next_) {
      const std::size_t i = order_[next_];
      double hole = size_of(moments(i));
      for (const GeneratorId g : neighbours(i)) hole += hole_[g.index()];
      if (hole > largest_hole_) continue;
      hole_[i] = hole;
      for (const GeneratorId g : neighbours(i)) hole_[g.index()] = hole_[g.index()] > 0 ? hole : 0;
      return order_[next_++];
    }
    return order_.size();
  }
  double energy(std::size_t i) const { return moments(i).energy; }

 private:
  const CellMoments& moments(std::size_t i) const { return state_.moments[GeneratorId(static_cast<std::int64_t>(i))]; }
  const std::vector<GeneratorId>& neighbours(std::size_t i) const { return neighbours_[i]; }

  const RelaxationState& state_;
  double largest_hole_;
  std::vector<std::size_t> order_;
  std::vector<double> hole_;  // size of the cells given up about it; 0 for a cell that stays
  std::vector<std::vector<GeneratorId>> neighbours_;
  std::size_t next_ = 0;
};

/// Chooses vertices far from all generators. Distances count times the fourth root of the density, as the radii of the
/// best cells do.
class FarVertices {
 public:
  FarVertices(const Mesh& mesh, const Density& density, const RelaxationState& state)
      : mesh_(mesh),
        scale_(static_cast<std::size_t>(mesh.vertex_count()), 1),
        distance_(static_cast<std::size_t>(mesh.vertex_count()), 0) {
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (!std::isfinite(state.vertex_distance[VertexId(v)])) continue;
      const SurfacePoint point = vertex_point(mesh, VertexId(v));
      scale_[static_cast<std::size_t>(v)] = std::pow(density.at(point.face, point.bary), 0.25);
      distance_[static_cast<std::size_t>(v)] = scale_[static_cast<std::size_t>(v)] * state.vertex_distance[VertexId(v)];
    }
  }

  VertexId farthest() const {
    const auto at = std::max_element(distance_.begin(), distance_.end());
    return VertexId(static_cast<std::int32_t>(at - distance_.begin()));
  }
  double distance(VertexId v) const { return distance_[v.index()]; }
  void take(VertexId taken) {
    const Vec3& p = mesh_.position(taken);
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      double& distance = distance_[static_cast<std::size_t>(v)];
      const double scale = scale_[static_cast<std::size_t>(v)];
      const double squared = scale * scale * (mesh_.position(VertexId(v)) - p).squaredNorm();
      if (squared < distance * distance) distance = std::sqrt(squared);
    }
  }

 private:
  const Mesh& mesh_;
  std::vector<double> scale_;     // fourth root of the density, of every vertex
  std::vector<double> distance_;  // of every vertex, to the nearest generator, scaled
};

}  // namespace

std::vector<Relocation> plan_relocations(const Mesh& mesh, const Density& density, const RelaxationState& state,
                                         const GeneratorConstraints& constraints) {
  const IdVector<FaceId, std::int32_t> components = compute_face_components(mesh);
  FarVertices places(mesh, density, state);
  const double least_distance = kLeastDistance * std::sqrt(mean_size(state) / std::numbers::pi);
  PoorCells poor(state);
  std::vector<Relocation> plan;
  while (plan.size() + 1 < state.generators.size()) {
    const std::size_t i = poor.take();
    if (i == state.generators.size()) break;
    if (!constraints.is_free(i)) continue;
    const VertexId v = places.farthest();
    const double distance = places.distance(v);
    const double gain = kSplitGain * std::pow(distance, 4) - kRemovalCost * poor.energy(i);
    if (!(distance > least_distance && gain > 0)) break;
    const SurfacePoint to = vertex_point(mesh, v);
    if (components[state.generators[i].face] != components[to.face]) continue;
    plan.push_back({i, to, gain});
    places.take(v);
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
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = relocations[k].generator;
    move.to[i] = relocations[k].to;
    move.length[i] = (position(mesh, move.to[i]) - position(mesh, state.generators[i])).norm();
  }
  move.relocated = static_cast<std::int32_t>(count);
  return move;
}

}  // namespace gvd
