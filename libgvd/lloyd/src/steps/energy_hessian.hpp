#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gvd/mesh.hpp"
#include "optimiser/tangent_field.hpp"
#include "state/relaxation_state.hpp"

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
  /// What one bisector takes from the Hessian of its two generators.
  struct Coupling {
    std::size_t left, right;
    Eigen::Matrix4d form;
  };
  TangentField multiply_couplings(const TangentField& field) const;

  std::vector<double> masses_;
  std::vector<Coupling> couplings_;
};

}  // namespace gvd
