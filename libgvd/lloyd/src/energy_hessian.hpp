#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// For each inner vertex, 2 pi minus the sum of the angles around it, radians; 0 on the boundary. Cost: O(n).
IdVector<VertexId, double> angle_defects(const Mesh& mesh);

/// The energy near a vertex close to a generator, as a cone: `slope` times the distance from the vertex.
struct EnergyCone {
  std::size_t generator;
  VertexId vertex;
  Vec2 at;       ///< the logarithm of the vertex at the generator; mesh units
  double slope;  ///< > 0 at a saddle, which attracts the generator; mesh units cubed
};

/// Local terms of all generators, used when the Hessian is solved.
struct LocalTerms {
  std::vector<Eigen::Matrix2d> curvature;  ///< added to the generator's own second derivative
  std::vector<Eigen::Matrix2d> allowed;    ///< projection onto the steps that the generator may take
};

/// The Hessian of the energy.
///
/// Moving generators i and j by u and v shifts their bisector. The Hessian is the diagonal of the masses, which are
/// twice the density's integrals, minus the sum over the bisectors of 2 / |X_i - X_j| times the integral of density ((a
/// . u) - (b . v))^2, where a and b are the logarithms of the bisector's points at the generators, and X_i and X_j are
/// the images of the generators in the plane of the face. That is exact in the plane. A vertex with an angle defect
/// bends the paths behind it, so the energy is less convex across the direction of the vertex, or more convex if the
/// defect is negative. That is exact to first order in the defect.
/// Source: Du, Faber and Gunzburger, Centroidal Voronoi tessellations, 1999, and Liu et al., On centroidal Voronoi
/// tessellation - energy smoothness and fast computation, 2009, section 3; docs/developer/lloyd.md, section 4.
class EnergyHessian {
 public:
  /// `defects`: the angle defects of the vertices. `scale`: the length of steps for which the matrix should be valid,
  /// mesh units, >= 0; a vertex nearer to a generator counts as if it were that far away. Vertices within `cone_reach`
  /// become cones, and are left out of the matrix.
  /// Cost: O(n + segments of the bisectors).
  EnergyHessian(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                double cone_reach = 0);

  /// The product of the inverse Hessian and `right`. Each eigenvalue relative to the masses is replaced by the larger
  /// of its absolute value and `least`, so that the result lowers the energy if `right` is minus the gradient.
  /// Approximate (Lanczos process).
  TangentField solve(const TangentField& right, double least) const;
  /// The same with local terms, for allowed steps.
  TangentField solve(const TangentField& right, double least, const LocalTerms& local) const;

  /// The product of the Hessian and `field`.
  TangentField multiply(const TangentField& field) const;

  const std::vector<EnergyCone>& cones() const { return cones_; }
  const std::vector<double>& masses() const { return masses_; }

 private:
  /// The part of a bisector, which is subtracted from the Hessian of its two generators.
  struct Coupling {
    std::size_t left, right;
    Eigen::Matrix4d form;
  };
  void add_bisectors(const std::vector<BisectorSegment>& segments);
  void add_defects(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                   double cone_reach);
  TangentField multiply_couplings(const TangentField& field) const;
  /// `couplings`: their product with fields relative to the masses.
  TangentField solve_relative(const FieldMap& couplings, const TangentField& relative, double least) const;

  std::vector<double> masses_;
  std::vector<Eigen::Matrix2d> shadows_;  // for each generator, the curvature that vertices subtract
  std::vector<Coupling> couplings_;
  std::vector<EnergyCone> cones_;
};

}  // namespace gvd
