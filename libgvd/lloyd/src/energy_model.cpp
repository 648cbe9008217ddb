// Models the energy near a state, and finds its minimum.
//
// The quadratic part has the Hessian without the vertices close to generators (energy_hessian). Each of these vertices
// adds a cone: to first order in its angle defect, the energy has the slope of a cone there, upwards at saddles and
// downwards at peaks. The tips of the cones are rounded. Newton's method with the absolute values of the eigenvalues
// finds the minimum. It needs no diagram, so its iterations are cheap. Generators rest at the tip of a cone that opens
// upwards.
#include "energy_model.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace gvd {
namespace {

/// Vertices within this distance of a generator, in mean cell radii, become cones.
constexpr double kConeReach = 0.4;

/// Radius of the rounded tips, in mean cell radii. It is less than the tolerance of the centroids.
constexpr double kTip = 5e-4;

/// Generators end at a vertex if they come nearer than this, in radii of the tip. At 1.5 the rounded cone has 83 % of
/// its slope.
constexpr double kAtTip = 1.5;

/// Number of iterations of Newton's method, and the factor by which they have to reduce the gradient. Further
/// iterations change the step by less than the error of the model.
constexpr int kIterations = 12;
constexpr double kReduction = 0.02;

/// Number of trials in an iteration, each with half the step.
constexpr int kTrials = 8;

/// A cone with a rounded tip, evaluated after a step.
struct RoundCone {
  Vec2 from_tip;
  double distance;  // rounded distance from the tip

  RoundCone(const EnergyCone& cone, const Vec2& step, double tip)
      : from_tip(step - cone.at), distance(std::hypot(from_tip.norm(), tip)) {}
  Vec2 direction() const { return from_tip / distance; }
};

double tip(const RelaxationState& state) { return kTip * state.mean_cell_radius; }

}  // namespace

EnergyModel::EnergyModel(const Mesh& mesh, const RelaxationState& state, const GeneratorConstraints& constraints,
                         const IdVector<VertexId, double>& defects)
    : mesh_(mesh),
      state_(state),
      constraints_(constraints),
      hessian_(state, defects, 0, kConeReach * state.mean_cell_radius),
      gradient_(energy_gradient(state)),
      held_(gradient_.size(), Vec2::Zero()) {
  for (std::size_t i = 0; i < gradient_.size(); ++i) {
    const SurfacePoint& at = state.generators[i];
    is_held_.push_back(at.kind() == SurfacePoint::Kind::vertex);
    if (is_held_[i] && !state.is_resting[i]) held_[i] = state.to_centroids[i];
    Eigen::Matrix2d allowed = Eigen::Matrix2d::Identity();
    if (!constraints.is_free(i)) {
      allowed << constraints.project(mesh, i, at, Vec2(1, 0)), constraints.project(mesh, i, at, Vec2(0, 1));
    }
    allowed_.push_back(is_held_[i] ? Eigen::Matrix2d(Eigen::Matrix2d::Zero()) : allowed);
  }
}

ModelEnergy EnergyModel::at(const TangentField& step) const {
  ModelEnergy energy{0, hessian_.multiply(step)};
  for (std::size_t i = 0; i < step.size(); ++i) {
    energy.change += (gradient_[i] + 0.5 * energy.gradient[i]).dot(step[i]);
    energy.gradient[i] += gradient_[i];
  }
  for (const EnergyCone& cone : hessian_.cones()) {
    const Vec2& u = step[cone.generator];
    const RoundCone start(cone, Vec2::Zero(), tip(state_)), end(cone, u, tip(state_));
    energy.change += cone.slope * (end.distance - start.distance - start.direction().dot(u));
    energy.gradient[cone.generator] += cone.slope * (end.direction() - start.direction());
  }
  for (std::size_t i = 0; i < step.size(); ++i) energy.gradient[i] = allowed_[i] * energy.gradient[i];
  return energy;
}

/// The curvature of the cones after a step.
LocalTerms EnergyModel::local_terms(const TangentField& step) const {
  LocalTerms local{std::vector<Eigen::Matrix2d>(step.size(), Eigen::Matrix2d::Zero()), allowed_};
  for (const EnergyCone& cone : hessian_.cones()) {
    const RoundCone round(cone, step[cone.generator], tip(state_));
    const Vec2 along = round.direction();
    local.curvature[cone.generator] +=
        cone.slope / round.distance * (Eigen::Matrix2d::Identity() - along * along.transpose());
  }
  return local;
}

TangentField EnergyModel::shortened(TangentField step, double reach) const {
  for (std::size_t i = 0; i < step.size(); ++i) {
    const double length = step[i].norm();
    if (!is_held_[i] && length > reach) step[i] *= reach / length;
  }
  return step;
}

double EnergyModel::length(const TangentField& gradient) const {
  double sum = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i) sum += gradient[i].squaredNorm() / hessian_.masses()[i];
  return std::sqrt(sum);
}

ModelMinimum EnergyModel::minimise(double reach, double least) const {
  TangentField step = held_;
  ModelEnergy energy = at(step);
  const double enough = kReduction * length(energy.gradient);
  bool has_moved = true;
  for (int k = 0; k < kIterations && has_moved && length(energy.gradient) > enough; ++k) {
    const TangentField way = hessian_.solve(energy.gradient, least, local_terms(step));
    const double slope = -dot(energy.gradient, way);
    has_moved = false;
    double share = 1;
    for (int trial = 0; trial < kTrials && !has_moved; ++trial, share *= 0.5) {
      TangentField next = shortened(add_scaled(step, -share, way), reach);
      ModelEnergy moved = at(next);
      has_moved = moved.change < energy.change + kSufficientFall * share * slope;
      if (has_moved) std::tie(step, energy) = std::pair(std::move(next), std::move(moved));
    }
  }
  const std::size_t size = step.size();
  ModelMinimum minimum{std::move(step), -energy.change, Rests(size)};
  add_rests(minimum);
  return minimum;
}

/// Sends generators that end at the tip of a cone to its saddle vertex.
void EnergyModel::add_rests(ModelMinimum& minimum) const {
  for (const EnergyCone& cone : hessian_.cones()) {
    const std::size_t i = cone.generator;
    if (is_held_[i] || !(cone.slope > 0) || !constraints_.is_free(i) || mesh_.is_boundary(cone.vertex)) continue;
    if ((minimum.step[i] - cone.at).norm() < kAtTip * tip(state_)) minimum.rest[i] = cone.vertex;
  }
}

}  // namespace gvd
