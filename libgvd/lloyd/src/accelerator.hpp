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

/// Steps of all generators, and the slope of the energy along them: a small fraction of the steps changes the energy by
/// this fraction of the slope.
struct ProposedSteps {
  TangentField steps;        ///< mesh units
  double slope = 0;          ///< < 0; mesh units to the fourth
  double prediction = 0;     ///< decrease of the energy by the steps according to the model, mesh units to the fourth
  bool is_of_model = false;  ///< whether the steps minimise EnergyModel within the trust radius
  Rests rest;                ///< the vertices at which generators rest instead
};

/// The error of differences of energies, as a fraction. For exact diagrams it comes from the integrals over triangles
/// that ridges cross.
inline constexpr double kEnergyError = 1e-6;

/// Estimates the rise of the energy along a move from its slopes at both ends of the paths.
double rise_by_slopes(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);

/// Proposes better steps than Lloyd's, by learning from earlier steps.
class Accelerator {
 public:
  /// All arguments must outlive this object.
  Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind);

  /// Returns steps from `state` that lower the energy if they are short enough; nothing if there are none.
  std::optional<ProposedSteps> propose(const RelaxationState& state) const;
  /// Learns from a move that was made. `rests`: the rests of `before` for these steps.
  void learn(const RelaxationState& before, const Rests& rests, const GeneratorMove& move,
             const RelaxationState& after);
  /// Forgets all earlier steps.
  void forget() {
    history_.clear();
    least_eigenvalue_ = kFirstLeastEigenvalue;
  }
  /// Reports that the steps were too long.
  void distrust() { least_eigenvalue_ = std::min(1.0, 4 * least_eigenvalue_); }
  /// Reports that steps of the model were too long. `longest` is the length of the longest, mesh units. Until steps are
  /// good again, the next ones are at most `factor` times as long.
  void shorten(double longest, double factor, const RelaxationState& state) {
    if (!(longest > 0)) return;
    radius_ = factor * std::min(radius_, longest / state.mean_cell_radius);
  }

 private:
  std::optional<ProposedSteps> propose_by_history(const RelaxationState& state) const;
  std::optional<ProposedSteps> propose_by_model(const RelaxationState& state) const;
  TangentField direction(const RelaxationState& state, const TangentField& gradient) const;

  /// Adapts the bound on eigenvalues and the trust radius to the ratio of the energy's fall to its prediction.
  void adapt(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);

  static constexpr double kFirstLeastEigenvalue = 0.1;

  /// Bounds of the trust radius, in mean cell radii.
  static constexpr double kFirstRadius = 0.2, kLeastRadius = 0.01, kLargestRadius = 1;

  const Mesh& mesh_;
  const GeneratorConstraints& constraints_;
  Acceleration kind_;
  IdVector<VertexId, double> defects_;               // angle defects of the vertices
  double least_eigenvalue_ = kFirstLeastEigenvalue;  // bound on eigenvalues, relative to the masses
  double radius_ = kFirstRadius;                     // trust radius of the model, in mean cell radii
  StepHistory history_;
};

}  // namespace gvd
