#pragma once

#include <vector>

#include "constraints.hpp"
#include "energy_hessian.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// The model's energy after a step.
struct ModelEnergy {
  double change = 0;      ///< of the energy, mesh units to the fourth
  TangentField gradient;  ///< projected onto allowed steps, mesh units cubed
};

/// A step towards the least energy of a model.
struct ModelMinimum {
  TangentField step;  ///< mesh units
  double fall = 0;    ///< of the model's energy, > 0 if the step is useful; mesh units to the fourth
  /// For each generator, the saddle vertex at which it ends, if any.
  Rests rest;
};

/// The energy near a state: a quadratic function of all steps, and a cone at each vertex close to a generator.
///
/// Within a face the energy is smooth, but it has a kink at every vertex with an angle defect. There the gradient
/// changes as much as over a step of a few hundredths of the cell radius. A quadratic function can't describe that, and
/// if generators lie near vertices, steps by the Hessian alone at best halve the residual.
class EnergyModel {
 public:
  /// `defects`: the angle defects of the vertices. Generators at vertices are held: they rest or take Lloyd's step. All
  /// arguments must outlive this object.
  /// Cost: O(n + segments of the bisectors).
  EnergyModel(const Mesh& mesh, const RelaxationState& state, const GeneratorConstraints& constraints,
              const IdVector<VertexId, double>& defects);

  ModelEnergy at(const TangentField& step) const;

  /// Minimises the model. No generator moves farther than `reach` (mesh units), except generators that are held.
  /// `least`: see EnergyHessian::solve. Cost: up to a dozen solutions with the Hessian.
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
  TangentField held_;      // the steps of held generators, 0 for all others
  std::vector<char> is_held_;
  std::vector<Eigen::Matrix2d> allowed_;
};

}  // namespace gvd
