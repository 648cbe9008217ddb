#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "energy_hessian.hpp"
#include "generator_moves.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// Steps of all generators, and the slope of the energy along them: the change by a small fraction of the steps is
/// this fraction of the slope.
struct ProposedSteps {
  TangentField steps;        ///< mesh units
  double slope = 0;          ///< < 0; mesh units to the fourth
  double prediction = 0;     ///< decrease of the energy by the steps according to the model, mesh units to the fourth
  bool is_of_model = false;  ///< whether EnergyModel has been minimised within the radius of trust
  Rests rest;                ///< where generators go to rest instead
};

/// Error of differences of energies, as a fraction: in exact diagrams, that of the integrals over triangles that ridges
/// cross.
inline constexpr double kEnergyError = 1e-6;

/// The rise of the energy along a move, from its slopes at both ends of the paths.
double rise_by_slopes(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);

/// Proposes better steps than Lloyd's, from the steps before.
class Accelerator {
 public:
  /// All arguments have to outlive this.
  Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind);

  /// Steps from `state` that lower the energy if they are short enough; no value if there are none.
  std::optional<ProposedSteps> propose(const RelaxationState& state) const;
  /// `rests`: of `before`, for the steps that were made.
  void learn(const RelaxationState& before, const Rests& rests, const GeneratorMove& move,
             const RelaxationState& after);
  /// Begins anew.
  void forget() {
    history_.clear();
    least_eigenvalue_ = kFirstLeastEigenvalue;
  }
  /// Tells that the steps were too long.
  void distrust() { least_eigenvalue_ = std::min(1.0, 4 * least_eigenvalue_); }
  /// Tells that steps of the model were too long. The next ones are at most `factor` times as long as the longest of
  /// them, which has this length (mesh units), until steps are good again.
  void shorten(double longest, double factor, const RelaxationState& state) {
    if (!(longest > 0)) return;
    radius_ = factor * std::min(radius_, longest / state.mean_cell_radius);
  }

 private:
  std::optional<ProposedSteps> propose_by_history(const RelaxationState& state) const;
  std::optional<ProposedSteps> propose_by_model(const RelaxationState& state) const;
  TangentField direction(const RelaxationState& state, const TangentField& gradient) const;

  /// Changes the least eigenvalue and the radius by what a move gave of what was predicted.
  void adapt(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);

  static constexpr double kFirstLeastEigenvalue = 0.1;

  /// Radius of trust, in mean cell radii.
  static constexpr double kFirstRadius = 0.2, kLeastRadius = 0.01, kLargestRadius = 1;

  const Mesh& mesh_;
  const GeneratorConstraints& constraints_;
  Acceleration kind_;
  IdVector<VertexId, double> defects_;               // of the angles round the vertices
  double least_eigenvalue_ = kFirstLeastEigenvalue;  // that counts, relative to the masses
  double radius_ = kFirstRadius;                     // of trust in the model, in mean cell radii
  StepHistory history_;
};

}  // namespace gvd
