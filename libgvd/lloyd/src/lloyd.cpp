// Lloyd's method on a surface, with backtracking: a step is taken only if it lowers the energy.
#include "gvd/lloyd.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cell_faces.hpp"
#include "cell_integrals.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "keep_apart.hpp"
#include "mesh/coincidence.hpp"

namespace gvd {
namespace {

/// The largest number of halvings of one generator's own step, and of all steps together: down to a thousandth each.
constexpr int kOwnHalvings = 10;
constexpr int kCommonHalvings = 10;

/// Least distance between two generators, as a fraction of the mean cell radius. A thousand times less than in any
/// relaxed diagram.
constexpr double kGap = 1e-6;

/// The same in distances at which two points coincide. It counts on surfaces with hardly any area.
constexpr double kGapOfCoincident = 2;

void check_options(const LloydOptions& o) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::invalid_option, message); };
  if (o.max_iterations < 0) refuse("the number of iterations must not be negative");
  if (!(o.energy_tolerance >= 0) || !std::isfinite(o.energy_tolerance))
    refuse("the energy tolerance must be 0 or more");
  if (!(o.move_tolerance >= 0) || !std::isfinite(o.move_tolerance)) refuse("the move tolerance must be 0 or more");
  if (!(o.step > 0 && o.step < 2)) refuse("the step must be above 0 and below 2");
}

/// A diagram and the integrals over its cells.
struct State {
  std::vector<SurfacePoint> generators;
  Diagram diagram;
  IdVector<GeneratorId, CellMoments> moments;
  double energy = 0;
};

struct Move {
  std::vector<SurfacePoint> to;
  std::vector<double> length;  // of every generator's path, mesh units
  double scale = 1;
  std::int32_t held = 0;
};

class Relaxer {
 public:
  Relaxer(const Mesh& mesh, const LloydOptions& options) : mesh_(mesh), options_(options), integrals_(mesh) {}

  LloydResult run(const std::vector<SurfacePoint>& generators) {
    report();
    State state = evaluate(generators);
    result_.initial_energy = state.energy;
    report_iteration(state.energy);
    result_.stop = iterate(state);
    result_.generators = std::move(state.generators);
    result_.diagram = std::move(state.diagram);
    result_.final_energy = state.energy;
    return std::move(result_);
  }

 private:
  LloydStop iterate(State& state) {
    while (true) {
      const std::vector<Vec2> steps = find_steps(state);
      if (result_.residual <= options_.move_tolerance * result_.mean_cell_radius) return LloydStop::centroids;
      if (result_.iterations.size() >= static_cast<std::size_t>(options_.max_iterations)) {
        return LloydStop::max_iterations;
      }
      const double before = state.energy;
      if (!descend(state, steps)) return LloydStop::no_descent;
      if (before - state.energy < options_.energy_tolerance * before) {
        find_steps(state);
        return LloydStop::energy;
      }
    }
  }

  State evaluate(const std::vector<SurfacePoint>& generators) {
    State state;
    state.generators = generators;
    DiagramOptions diagram_options = options_.diagram;
    diagram_options.progress = [this](std::string_view step, double fraction) {
      const auto begun = std::find(steps::kAll.begin(), steps::kAll.end(), step) - steps::kAll.begin();
      report((static_cast<double>(begun) + fraction) / static_cast<double>(steps::kAll.size()));
      return true;
    };
    state.diagram = compute_diagram(mesh_, generators, diagram_options);
    ++result_.diagrams;
    const CellFaces cells(state.diagram);
    state.moments.resize(generators.size());
    for (std::size_t i = 0; i < generators.size(); ++i) {
      const GeneratorId g(static_cast<std::int64_t>(i));
      state.moments[g] = integrals_.compute(generators[i], cells.of(g));
      state.energy += state.moments[g].energy;
    }
    return state;
  }

  /// The tangent vectors to the centroids, projected to the boundary where they would leave the surface. Updates
  /// `residual` and `mean_cell_radius`.
  std::vector<Vec2> find_steps(const State& state) {
    std::vector<Vec2> steps;
    double area = 0;
    result_.residual = 0;
    for (std::size_t i = 0; i < state.generators.size(); ++i) {
      const CellMoments& m = state.moments[GeneratorId(static_cast<std::int64_t>(i))];
      area += m.area;
      steps.push_back(project_to_surface(mesh_, state.generators[i], m.centroid));
      result_.residual = std::max(result_.residual, steps.back().norm());
    }
    result_.mean_cell_radius = std::sqrt(area / (std::numbers::pi * static_cast<double>(steps.size())));
    return steps;
  }

  /// One iteration: takes the first move that lowers the energy. False if none does.
  bool descend(State& state, const std::vector<Vec2>& steps) {
    std::vector<double> scale(steps.size(), options_.step);
    if (take_if_lower(state, move(state, steps, scale))) return true;
    scale = find_own_scales(state, steps);
    for (int halving = 0; halving <= kCommonHalvings; ++halving) {
      Move next = move(state, steps, scale);
      next.scale = std::ldexp(1.0, -halving);
      if (take_if_lower(state, std::move(next))) return true;
      for (double& s : scale) s *= 0.5;
    }
    return false;
  }

  Move move(const State& state, const std::vector<Vec2>& steps, const std::vector<double>& scale) const {
    Move next;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const GeodesicTrace trace = trace_geodesic(mesh_, state.generators[i], scale[i] * steps[i]);
      next.to.push_back(trace.points.back());
      next.length.push_back(trace.length);
      next.held += scale[i] == 0;
    }
    const double gap = std::max(kGap * result_.mean_cell_radius, kGapOfCoincident * coincidence(mesh_));
    next.held += keep_apart(mesh_, state.generators, gap, next.to);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (next.to[i] == state.generators[i]) next.length[i] = 0;
    }
    return next;
  }

  bool take_if_lower(State& state, Move next) {
    if (next.to == state.generators) return false;
    State moved = evaluate(next.to);
    if (!(moved.energy < state.energy)) return false;
    LloydIteration iteration;
    iteration.energy = moved.energy;
    for (const double length : next.length) {
      iteration.largest_move = std::max(iteration.largest_move, length);
      iteration.mean_move += length / static_cast<double>(next.length.size());
    }
    iteration.scale = next.scale;
    iteration.held = next.held;
    result_.iterations.push_back(iteration);
    report_iteration(moved.energy);
    state = std::move(moved);
    return true;
  }

  /// For each generator the largest fraction of its step, out of 1, 1/2, ... and 0, that lowers the energy of its cell
  /// while the cell stays fixed. The diagram of the moved generators has at most the energy of these fixed cells, up to
  /// the errors of the distances.
  std::vector<double> find_own_scales(const State& state, const std::vector<Vec2>& steps) {
    const CellFaces cells(state.diagram);
    std::vector<double> scales;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      report();
      const GeneratorId g(static_cast<std::int64_t>(i));
      double scale = options_.step;
      int halvings = 0;
      const auto lowers = [&] {
        const SurfacePoint to = trace_geodesic(mesh_, state.generators[i], scale * steps[i]).points.back();
        return integrals_.compute(to, cells.of(g)).energy < state.moments[g].energy;
      };
      while (scale > 0 && !lowers()) scale = ++halvings > kOwnHalvings ? 0 : 0.5 * scale;
      scales.push_back(scale);
    }
    return scales;
  }

  /// `share`: of the next iteration, if its first step is taken.
  void report(double share = 0) const {
    const double done = static_cast<double>(result_.iterations.size()) + std::min(share, 1.0);
    report_progress(options_.progress, "relaxation",
                    std::min(1.0, done / std::max(1.0, double(options_.max_iterations))));
  }

  void report_iteration(double energy) const {
    if (options_.on_iteration) options_.on_iteration(std::ssize(result_.iterations), energy);
  }

  const Mesh& mesh_;
  const LloydOptions& options_;
  CellIntegrals integrals_;
  LloydResult result_;
};

}  // namespace

LloydResult relax_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const LloydOptions& options) {
  check_options(options);
  return Relaxer(mesh, options).run(generators);
}

}  // namespace gvd
