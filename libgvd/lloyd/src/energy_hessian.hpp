#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// 360 degrees minus the sum of the angles round each inner vertex, radians; 0 on the boundary. Cost: O(n).
IdVector<VertexId, double> angle_defects(const Mesh& mesh);

/// The energy beside a vertex that a generator is near: `slope` times the distance from it, as a cone.
struct EnergyCone {
  std::size_t generator;
  VertexId vertex;
  Vec2 at;       ///< the vertex, as seen from the generator; mesh units
  double slope;  ///< > 0 at a saddle, which draws the generator; mesh units cubed
};

/// Terms that are added to the Hessian before it is solved, each for all generators.
struct LocalTerms {
  std::vector<Eigen::Matrix2d> curvature;  ///< added to the generator's own second derivative
  std::vector<Eigen::Matrix2d> allowed;    ///< projection to the steps that the generator may take
};

/// The Hessian of the energy.
///
/// Moving generators i and j by u and v shifts their bisector. The Hessian is the diagonal of the masses, twice the
/// density's integrals, minus the sum over the bisectors of 2 / |X_i - X_j| times the integral of density ((a . u) - (b
/// . v))^2, where a and b are the logarithms of the bisector's points at the generators, and X_i and X_j the images of
/// the generators in the plane of the face. That is exact in the plane. A vertex with an angle defect bends the paths
/// behind it: there the energy is less convex across the direction of the vertex, or more where the defect is
/// negative. That is exact to the first order of the defect.
/// Source: Du, Faber and Gunzburger, Centroidal Voronoi tessellations, 1999, and Liu et al., On centroidal Voronoi
/// tessellation - energy smoothness and fast computation, 2009, section 3; docs/developer/lloyd.md, section 4.
class EnergyHessian {
 public:
  /// `defects`: of the vertices. `scale`: the length of steps that the matrix shall tell of, mesh units, >= 0. A vertex
  /// that is nearer to a generator counts as if it were that far away. Vertices within `cone_reach` are cones, and the
  /// matrix leaves them out.
  /// Cost: O(n + segments of the bisectors).
  EnergyHessian(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                double cone_reach = 0);

  /// The product of the Hessian's inverse and `right`. Each eigenvalue, relative to the masses, is replaced by its
  /// absolute value, or by `least` if that is less: the result is a step that lowers the energy where `right` is minus
  /// the gradient. Approximate (Lanczos process).
  TangentField solve(const TangentField& right, double least) const;
  /// The same with local terms, for steps that are allowed.
  TangentField solve(const TangentField& right, double least, const LocalTerms& local) const;

  /// The product of the Hessian and `field`.
  TangentField multiply(const TangentField& field) const;

  const std::vector<EnergyCone>& cones() const { return cones_; }
  const std::vector<double>& masses() const { return masses_; }

 private:
  /// The part of one bisector, which is subtracted from the Hessian of its two generators.
  struct Coupling {
    std::size_t left, right;
    Eigen::Matrix4d form;
  };
  void add_bisectors(const std::vector<BisectorSegment>& segments);
  void add_defects(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                   double cone_reach);
  TangentField multiply_couplings(const TangentField& field) const;
  /// `couplings`: of fields relative to the masses.
  TangentField solve_relative(const FieldMap& couplings, const TangentField& relative, double least) const;

  std::vector<double> masses_;
  std::vector<Eigen::Matrix2d> shadows_;  // of each generator: what the vertices subtract
  std::vector<Coupling> couplings_;
  std::vector<EnergyCone> cones_;
};

}  // namespace gvd
