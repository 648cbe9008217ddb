#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "generator_moves.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// The approximate Hessian of the energy, for a quasi-Newton method to begin with.
///
/// Moving generators i and j by u and v shifts their bisector. The Hessian is the diagonal of the masses, twice the
/// density's integrals, minus the sum over the bisectors of 2 / |x_i - x_j| times the integral of density ((a . u) - (b
/// . v))^2, where a and b lead from the generators to the point of the bisector. That is exact in the plane. On a
/// surface, a and b are replaced by straight vectors in space, projected to the tangent planes: exact in the limit of
/// small cells.
/// Source: Du, Faber and Gunzburger, Centroidal Voronoi tessellations, 1999, and Liu et al., On centroidal Voronoi
/// tessellation - energy smoothness and fast computation, 2009, section 3.
class EnergyHessian {
 public:
  /// Cost: O(segments of the bisectors).
  EnergyHessian(const Mesh& mesh, const RelaxationState& state);

  /// The product of the Hessian's inverse and `right`. Each eigenvalue, relative to the masses, is replaced by its
  /// absolute value, or by 1 / 10 if that is less: the result is a step that lowers the energy where `right` is minus
  /// the gradient. Approximate (Lanczos process).
  TangentField solve(const TangentField& right) const;

  /// The product of the Hessian and `field`.
  TangentField multiply(const TangentField& field) const;

 private:
  /// The part of one bisector, which is subtracted from the Hessian of its two generators.
  struct Coupling {
    std::size_t left, right;
    Eigen::Matrix4d form;
  };
  TangentField multiply_couplings(const TangentField& field) const;

  std::vector<double> masses_;
  std::vector<Coupling> couplings_;
};

/// Steps of all generators, and the slope of the energy along them: the change by a small fraction of the steps is
/// this fraction of the slope.
struct ProposedSteps {
  TangentField steps;  ///< mesh units
  double slope = 0;    ///< < 0; mesh units to the fourth
};

/// Proposes better steps than Lloyd's, from the steps before.
class Accelerator {
 public:
  /// All arguments have to outlive this.
  Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind);

  /// Steps from `state` that lower the energy if they are short enough; no value if there are none.
  std::optional<ProposedSteps> propose(const RelaxationState& state) const;
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
