#include "accelerator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "energy_hessian.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "optimiser/anderson.hpp"
#include "optimiser/lbfgs.hpp"

namespace gvd {
namespace {

/// Pairs that are kept. With 5, 10 and 20 pairs of L-BFGS runs on the bunny take as many iterations, within 5 %.
constexpr std::size_t kLbfgsMemory = 7;
constexpr std::size_t kAndersonMemory = 6;

/// Longest step of a generator, in mean cell radii, or in ways to its centroid if that is more: beyond this the
/// neighbours of cells change.
constexpr double kLongestStep = 1;

/// Least curvature of a pair, as a fraction of that of the masses: it keeps the inverse Hessian positive definite and
/// below a hundred times Lloyd's.
constexpr double kLeastCurvature = 0.01;

bool has_curvature(const StepPair& pair, const std::vector<double>& masses) {
  double expected = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) expected += masses[i] * pair.step[i].squaredNorm();
  return expected > 0 && dot(pair.step, pair.change) > kLeastCurvature * expected;
}

/// Generators that rest, or go to rest, have no step.
bool is_held(const RelaxationState& state, std::size_t i) { return state.is_resting[i] || state.rest[i]; }

/// Where the gradient is not that of a smooth function, the steps of other generators tell nothing about that of this
/// one. It takes Lloyd's.
bool is_at_kink(const RelaxationState& state, std::size_t i) {
  return is_held(state, i) || state.generators[i].kind() == SurfacePoint::Kind::vertex;
}

}  // namespace

Accelerator::Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind)
    : mesh_(mesh),
      constraints_(constraints),
      kind_(kind),
      history_(kind == Acceleration::anderson ? kAndersonMemory : kLbfgsMemory) {}

std::optional<ProposedSteps> Accelerator::propose(const RelaxationState& state) const {
  if (kind_ == Acceleration::none) return std::nullopt;
  const TangentField gradient = energy_gradient(state);
  TangentField smooth = gradient;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    if (is_at_kink(state, i)) smooth[i] = Vec2::Zero();
  }
  ProposedSteps proposed{direction(state, smooth), 0};
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    Vec2& step = proposed.steps[i];
    const double longest = kLongestStep * std::max(state.mean_cell_radius, state.to_centroids[i].norm());
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > longest) step *= longest / step.norm();
    if (is_at_kink(state, i)) step = is_held(state, i) ? Vec2(Vec2::Zero()) : state.to_centroids[i];
    step = constraints_.project(mesh_, i, state.generators[i], step);
  }
  proposed.slope = dot(gradient, proposed.steps);
  if (!(proposed.slope < 0)) return std::nullopt;
  return proposed;
}

TangentField Accelerator::direction(const RelaxationState& state, const TangentField& gradient) const {
  if (kind_ == Acceleration::anderson) return anderson_step(history_, state.to_centroids);
  const EnergyHessian hessian(mesh_, state);
  return lbfgs_direction(history_, gradient, [&](const TangentField& field) { return hessian.solve(field); });
}

void Accelerator::learn(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after) {
  if (kind_ == Acceleration::none) return;
  history_.transport(move.turns);
  const bool by_gradient = kind_ == Acceleration::lbfgs;
  const TangentField start = by_gradient ? energy_gradient(before) : before.to_centroids;
  const TangentField end = by_gradient ? energy_gradient(after) : after.to_centroids;
  StepPair pair{move.step, add_scaled(end, -1, turned(move.turns, start))};
  for (std::size_t i = 0; i < pair.step.size(); ++i) {
    if (is_at_kink(before, i) || is_at_kink(after, i)) pair.step[i] = pair.change[i] = Vec2::Zero();
  }
  if (!by_gradient || has_curvature(pair, cell_masses(after))) history_.add(std::move(pair));
}

}  // namespace gvd
