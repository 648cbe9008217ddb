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
  TangentField steps;     ///< mesh units
  double slope = 0;       ///< < 0; mesh units to the fourth
  double prediction = 0;  ///< decrease of the energy by the steps according to the model, mesh units to the fourth
};

/// Proposes better steps than Lloyd's, from the steps before.
class Accelerator {
 public:
  /// All arguments have to outlive this.
  Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind);

  /// Steps from `state` that lower the energy if they are short enough; no value if there are none.
  std::optional<ProposedSteps> propose(const RelaxationState& state) const;
  void learn(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);
  /// Begins anew.
  void forget() {
    history_.clear();
    least_eigenvalue_ = kFirstLeastEigenvalue;
  }
  /// Tells that the steps were too long.
  void distrust() { least_eigenvalue_ = std::min(1.0, 4 * least_eigenvalue_); }

 private:
  TangentField direction(const RelaxationState& state, const TangentField& gradient) const;

  /// Changes the least eigenvalue by what a move gave of what was predicted.
  void adapt(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);

  static constexpr double kFirstLeastEigenvalue = 0.1;

  const Mesh& mesh_;
  const GeneratorConstraints& constraints_;
  Acceleration kind_;
  IdVector<VertexId, double> defects_;               // of the angles round the vertices
  double least_eigenvalue_ = kFirstLeastEigenvalue;  // that counts, relative to the masses
  StepHistory history_;
};

}  // namespace gvd
