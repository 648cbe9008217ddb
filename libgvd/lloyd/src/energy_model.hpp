#pragma once

#include <vector>

#include "constraints.hpp"
#include "energy_hessian.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// The energy after a step, by a model.
struct ModelEnergy {
  double change = 0;      ///< of the energy, mesh units to the fourth
  TangentField gradient;  ///< where the generators may go, mesh units cubed
};

/// A step towards the least energy of a model.
struct ModelMinimum {
  TangentField step;  ///< mesh units
  double fall = 0;    ///< of the model's energy, > 0 if it is any use; mesh units to the fourth
  /// The saddle vertex at which each generator ends, if any.
  Rests rest;
};

/// The energy near a state: a quadratic function of all steps, and a cone at each vertex beside a generator.
///
/// Within a face the energy is smooth, but it has a kink at every vertex with an angle defect. The gradient changes
/// there by as much as by a step of some hundredths of the cell radius. No quadratic function tells that, and where
/// generators lie near vertices, steps by the Hessian alone halve the residual at best.
class EnergyModel {
 public:
  /// `defects`: of the vertices. Generators at vertices are held: they rest, or take Lloyd's step. All arguments have
  /// to outlive this.
  /// Cost: O(n + segments of the bisectors).
  EnergyModel(const Mesh& mesh, const RelaxationState& state, const GeneratorConstraints& constraints,
              const IdVector<VertexId, double>& defects);

  ModelEnergy at(const TangentField& step) const;

  /// No generator goes farther than `reach` (mesh units), but those that are held. `least`: see EnergyHessian::solve.
  /// Cost: up to a dozen solutions with the Hessian.
  ModelMinimum minimise(double reach, double least) const;

 private:
  LocalTerms local_terms(const TangentField& step) const;
  TangentField shortened(TangentField step, double reach) const;
  double length(const TangentField& gradient) const;
  void add_rests(ModelMinimum& minimum) const;

  const Mesh& mesh_;
  const RelaxationState& state_;
  const GeneratorConstraints& constraints_;
  EnergyHessian hessian_;
  TangentField gradient_;  // at the state
  TangentField held_;      // the steps of generators that are held, else 0
  std::vector<char> is_held_;
  std::vector<Eigen::Matrix2d> allowed_;
};

}  // namespace gvd
