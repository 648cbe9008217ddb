// Computes better steps than Lloyd's, by L-BFGS with the Hessian of the energy.
//
// L-BFGS starts from the Hessian of the energy (energy_hessian.hpp). Small eigenvalues allow long steps, so eigenvalues
// below a bound are replaced by it. Like the radius of a trust region, the bound adapts: it falls while the model's
// predictions are good, and rises when they are poor. Near the end, the Hessian is combined with cones at nearby
// vertices (energy_model.hpp) instead of pairs, because there these vertices change the gradient most. Sources are in
// optimiser.hpp. Generators at vertices take no part, because the gradient jumps there; they take Lloyd's step or rest.
#include "accelerator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "energy_model.hpp"

namespace gvd {
namespace {

/// The smallest bound on absolute eigenvalues, relative to the masses. Steps are at most the inverse of the bound times
/// as long as Lloyd's. If the energy fell by .7 to 1.6 of its prediction after a full step near the end, the bound is
/// halved; if it fell by less than .3, the bound is doubled.
constexpr double kLeastEigenvalue = 0.01;
constexpr std::pair<double, double> kGoodRatio{0.7, 1.6};
constexpr double kPoorRatio = 0.3;

/// The trust radius is halved after a step with a poor ratio. It is doubled after a step that was nearly as long as the
/// radius and achieved at least this part of its prediction.
constexpr double kTrustedRatio = 0.5, kNearRadius = 0.8;

/// Longer steps, and steps of the model with cones, are allowed only if the prediction is below this fraction of the
/// energy. Far from the end the valleys of the energy bend, and longer steps cost more diagrams than they save.
constexpr double kNearEnd = 1e-3;

/// Vertices nearer to a generator than this, in mean cell radii, count as if they were that far away, because steps are
/// longer than the way past them.
constexpr double kNearVertex = 0.02;

/// Number of pairs that are kept. Runs with 5 to 20 pairs take about as many iterations.
constexpr std::size_t kMemory = 7;

/// Longest step of a generator, in mean cell radii or, if that is more, in distances to its centroid. With longer
/// steps, the neighbours of cells change.
constexpr double kLongestStep = 1;

/// The least curvature of a pair, as a fraction of the curvature of the masses. It keeps the inverse Hessian positive
/// definite and at most a hundred times Lloyd's.
constexpr double kLeastCurvature = 0.01;

bool has_curvature(const StepPair& pair, const std::vector<double>& masses) {
  double expected = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) expected += masses[i] * pair.step[i].squaredNorm();
  return expected > 0 && dot(pair.step, pair.change) > kLeastCurvature * expected;
}

}  // namespace

double rise_by_slopes(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after) {
  const double first = dot(turned(move.turns, energy_gradient(before)), move.step);
  return 0.5 * (first + dot(energy_gradient(after), move.step));
}

Accelerator::Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind)
    : mesh_(mesh),
      constraints_(constraints),
      kind_(kind),
      defects_(kind == Acceleration::none ? IdVector<VertexId, double>() : angle_defects(mesh)),
      history_(kMemory) {}

std::optional<ProposedSteps> Accelerator::propose(const RelaxationState& state) const {
  if (kind_ == Acceleration::none) return std::nullopt;
  std::optional<ProposedSteps> proposed = propose_by_history(state);
  if (proposed && proposed->prediction >= kNearEnd * state.energy) return proposed;
  std::optional<ProposedSteps> by_model = propose_by_model(state);
  return by_model ? by_model : proposed;
}

std::optional<ProposedSteps> Accelerator::propose_by_history(const RelaxationState& state) const {
  const TangentField gradient = energy_gradient(state);
  TangentField smooth = gradient;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    if (is_at_kink(state, state.rest, i)) smooth[i] = Vec2::Zero();
  }
  ProposedSteps proposed{direction(state, smooth), 0, 0, false, state.rest};
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    Vec2& step = proposed.steps[i];
    const double longest = kLongestStep * std::max(state.mean_cell_radius, state.to_centroids[i].norm());
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > longest) step *= longest / step.norm();
    if (is_at_kink(state, state.rest, i)) {
      const bool is_held = state.is_resting[i] || state.rest[i];
      step = is_held ? Vec2(Vec2::Zero()) : state.to_centroids[i];
    }
    step = constraints_.project(mesh_, i, state.generators[i], step);
  }
  proposed.slope = dot(gradient, proposed.steps);
  proposed.prediction = -0.5 * proposed.slope;
  if (!(proposed.slope < 0)) return std::nullopt;
  return proposed;
}

std::optional<ProposedSteps> Accelerator::propose_by_model(const RelaxationState& state) const {
  const EnergyModel model(mesh_, state, constraints_, defects_);
  ModelMinimum minimum = model.minimise(radius_ * state.mean_cell_radius, least_eigenvalue_);
  if (!(minimum.fall > 0)) return std::nullopt;
  ProposedSteps proposed{std::move(minimum.step), -minimum.fall, minimum.fall, true, std::move(minimum.rest)};
  for (std::size_t i = 0; i < proposed.steps.size(); ++i) {
    Vec2& step = proposed.steps[i];
    if (!step.allFinite()) return std::nullopt;
    if (state.is_resting[i]) step = Vec2::Zero();
    step = constraints_.project(mesh_, i, state.generators[i], step);
  }
  return proposed;
}

TangentField Accelerator::direction(const RelaxationState& state, const TangentField& gradient) const {
  const EnergyHessian hessian(state, defects_, kNearVertex * state.mean_cell_radius);
  return lbfgs_direction(history_, gradient,
                         [&](const TangentField& field) { return hessian.solve(field, least_eigenvalue_); });
}

void Accelerator::adapt(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after) {
  if (!(move.prediction > 0)) return;
  double fall = before.energy - after.energy;
  if (fall < kEnergyError * before.energy) fall = std::max(fall, -rise_by_slopes(before, move, after));
  const double ratio = fall / move.prediction;
  const bool is_near_end = move.prediction < kNearEnd * before.energy;
  if (is_near_end && move.scale == 1 && ratio > kGoodRatio.first && ratio < kGoodRatio.second) {
    least_eigenvalue_ = std::max(kLeastEigenvalue, 0.5 * least_eigenvalue_);
  }
  if (ratio < kPoorRatio) least_eigenvalue_ = std::min(1.0, 2 * least_eigenvalue_);
  const double longest = *std::max_element(move.length.begin(), move.length.end()) / after.mean_cell_radius;
  if (ratio < kPoorRatio) radius_ = std::max(kLeastRadius, std::min(radius_, 0.5 * longest));
  if (ratio > kTrustedRatio && longest > kNearRadius * radius_) radius_ = std::min(kLargestRadius, 2 * radius_);
}

void Accelerator::learn(const RelaxationState& before, const Rests& rests, const GeneratorMove& move,
                        const RelaxationState& after) {
  if (kind_ == Acceleration::none) return;
  adapt(before, move, after);
  history_.transport(move.turns);
  StepPair pair{move.step, add_scaled(energy_gradient(after), -1, turned(move.turns, energy_gradient(before)))};
  for (std::size_t i = 0; i < pair.step.size(); ++i) {
    if (is_at_kink(before, rests, i) || is_at_kink(after, after.rest, i)) pair.step[i] = pair.change[i] = Vec2::Zero();
  }
  if (has_curvature(pair, cell_masses(after))) history_.add(std::move(pair));
}

}  // namespace gvd
