#pragma once

#include <optional>

#include "gvd/acceleration.hpp"
#include "gvd/mesh.hpp"
#include "optimiser/step_history.hpp"
#include "state/generator_moves.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// Steps of all generators, and the slope of the energy along them: the change by a small fraction of the steps is
/// this fraction of the slope.
struct ProposedSteps {
  TangentField steps;  ///< mesh units
  double slope = 0;    ///< < 0; mesh units to the fourth
};

/// Proposes better steps than Lloyd's, from the steps before.
class Accelerator {
 public:
  /// All have to outlive this.
  Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind);

  /// Steps from `state` that lower the energy if they are short enough; without any if there is no such proposal.
  std::optional<ProposedSteps> propose(const RelaxationState& state) const;
  /// Learns from a move of the generators.
  void learn(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after);
  void forget() { history_.clear(); }

 private:
  TangentField direction(const RelaxationState& state, const TangentField& gradient) const;

  const Mesh& mesh_;
  const GeneratorConstraints& constraints_;
  Acceleration kind_;
  StepHistory history_;
};

}  // namespace gvd
