#pragma once

#include <vector>

#include "gvd/cell_moments.hpp"
#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

struct BalanceOptions {
  Density density = {};             ///< what the cells share; the area where it is uniform
  std::vector<double> shares = {};  ///< of each generator, > 0; only their ratios matter. Empty: equal ones
  /// The search ends when the root mean square of mass / target - 1 is at most this, > 0.
  double tolerance = 1e-7;
  int max_diagrams = 60;        ///< the search ends after so many, >= 1
  DiagramOptions diagram = {};  ///< its `weights` are those that the search starts from; empty: 0 for all
};

/// A diagram with weights by which each cell has its share.
struct BalancedDiagram {
  Diagram diagram;              ///< with the weights
  std::vector<double> masses;   ///< of the cells: the integral of the density, square mesh units for the area
  std::vector<double> targets;  ///< of the cells; those of one component of the mesh add up to its mass
  double variation = 0;         ///< root mean square of mass / target - 1
  int diagrams = 0;             ///< that were computed
  /// Sets of cells that have their targets together, but not each for itself (see `balance_cells`). Ascending.
  std::vector<std::vector<GeneratorId>> tied;
  bool converged = false;  ///< every cell, or set of tied cells, has its target to `tolerance`
};

/// Finds additive weights of the generators by which each cell has its share of the mass.
///
/// The weights maximise a concave function whose gradient is the excess of the masses over the targets, and whose
/// Hessian has the rates of the bisectors: a damped Newton method with sparse Cholesky factors. Where no weights give
/// the shares, this is for one of two reasons. Behind a saddle or a reflex vertex, two generators whose paths both bend
/// there can tie in a whole part of the surface, which then belongs to either. Or the weight of a generator is at its
/// bound: two weights differ by less than the distance of their generators. The cells concerned are then tied: they
/// have their targets together, and the search goes on for all others.
/// Properties: (1) the diagram is exact, and passes check_diagram; (2) no bit depends on the number of threads;
/// (3) every generator owns its place.
/// Throws Error{invalid_option} where an option is out of its range, or the method is not exact; what compute_diagram
/// throws; Error{precondition} where the density is not of this mesh or a component with generators has no mass.
/// Cost: 5 to 11 diagrams with farthest generators, as measured; up to `max_diagrams` with random ones.
/// Source: J. Kitagawa, Q. Merigot and B. Thibert, Convergence of a Newton algorithm for semi-discrete optimal
/// transport, 2019, with geodesic distances as the cost.
BalancedDiagram balance_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                              const BalanceOptions& options = {});

struct BalancedRelaxationOptions {
  BalanceOptions balance = {};
  Density density = {};               ///< weight of the surface in the centroids, as in LloydOptions
  std::vector<Freedom> freedom = {};  ///< how each generator may move, one for each; empty: all are free
  std::vector<EdgeId> creases = {};   ///< of the generators that stay on creases
  int max_rounds = 10;                ///< moves of all generators, >= 0
  /// Stop if no centroid is farther from its generator than this fraction of the mean cell radius, >= 0.
  double move_tolerance = 1e-2;
};

struct BalancedRelaxation {
  BalancedDiagram balanced;                    ///< of the generators that were reached
  IdVector<GeneratorId, CellMoments> moments;  ///< of its cells
  int rounds = 0;                              ///< moves of all generators
  int diagrams = 0;                            ///< of all rounds
  double residual = 0;                         ///< largest distance from a generator to its centroid, mesh units
  double mean_cell_radius = 0;                 ///< sqrt(area / (pi cells)), mesh units
};

/// In turns, balances the cells and moves every generator to the centroid of its cell: near the end, cells are equal
/// and generators at their centroids. Ends with balanced cells. The generators are best relaxed before.
/// Throws what balance_cells throws; Error{invalid_option} for a negative limit; Error{precondition} where the freedoms
/// do not fit the generators. Cost: 3 to 5 diagrams a round. After ten rounds, generators are within 1 % of the mean
/// cell radius of their centroids on smooth models, and within 20 % on thin ones; more rounds gain little.
BalancedRelaxation relax_balanced(const Mesh& mesh, std::vector<SurfacePoint> generators,
                                  const BalancedRelaxationOptions& options = {});

}  // namespace gvd
