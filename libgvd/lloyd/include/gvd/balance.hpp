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
  Density density = {};             ///< the density of the mass that the cells share; if uniform, the mass is the area
  std::vector<double> shares = {};  ///< the share of each generator, > 0; only the ratios matter. Empty: equal shares
  /// The search ends when the root mean square of mass / target - 1 is at most this, > 0.
  double tolerance = 1e-7;
  int max_diagrams = 60;        ///< the search ends after this many, >= 1
  DiagramOptions diagram = {};  ///< the search starts from its `weights`; empty: 0 for all
};

/// A diagram with weights that give each cell its share.
struct BalancedDiagram {
  Diagram diagram;              ///< with the weights
  std::vector<double> masses;   ///< of the cells: the integral of the density, square mesh units if that is 1
  std::vector<double> targets;  ///< of the cells; in each component of the mesh they add up to its mass
  double variation = 0;         ///< root mean square of mass / target - 1
  int diagrams = 0;             ///< number of diagrams computed
  /// Sets of cells that meet their targets only together, not individually (see `balance_cells`). Ascending.
  std::vector<std::vector<GeneratorId>> tied;
  bool converged = false;  ///< every cell, or set of tied cells, meets its target within `tolerance`
};

/// Finds additive weights of the generators that give each cell its share of the mass.
///
/// The weights maximise a concave function. Its gradient is the excess of the masses over the targets, and its Hessian
/// consists of the rates at which bisectors pass mass. The search is a damped Newton method with sparse Cholesky
/// factors. There are two reasons why no weights may give the shares. First, behind a saddle or a reflex vertex, two
/// generators whose paths both bend there can tie in a whole part of the surface, which then is assigned entirely to
/// one of them. Second, the weight of a generator can reach its bound, because two weights must differ by less than the
/// distance of their generators. The cells concerned are then tied: they meet their targets together, and the search
/// continues for all others.
/// Properties: (1) the diagram is exact, and passes check_diagram; (2) the result does not depend on the number of
/// threads; (3) every generator lies in its own cell.
/// Throws Error{invalid_option} if an option is out of range or the method is not exact; what `compute_diagram` throws;
/// Error{precondition} if the density does not belong to this mesh, or if a component with generators has no mass.
/// Cost: 5 to 11 diagrams for farthest generators, as measured; up to `max_diagrams` for random ones.
/// Source: J. Kitagawa, Q. Merigot and B. Thibert, Convergence of a Newton algorithm for semi-discrete optimal
/// transport, 2019, with geodesic distances as the cost.
BalancedDiagram balance_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                              const BalanceOptions& options = {});

struct BalancedRelaxationOptions {
  BalanceOptions balance = {};
  Density density = {};               ///< weight of the surface in the centroids, as in LloydOptions
  std::vector<Freedom> freedom = {};  ///< how each generator may move; empty: all are free
  std::vector<EdgeId> creases = {};   ///< for the generators that stay on creases
  int max_rounds = 10;                ///< largest number of rounds, each of which moves all generators, >= 0
  /// Stop if no centroid is farther from its generator than this fraction of the mean cell radius, >= 0.
  double move_tolerance = 1e-2;
};

struct BalancedRelaxation {
  BalancedDiagram balanced;                    ///< of the final generators
  IdVector<GeneratorId, CellMoments> moments;  ///< of the cells of `balanced`
  int rounds = 0;                              ///< number of rounds
  int diagrams = 0;                            ///< number of diagrams in all rounds
  double residual = 0;                         ///< largest distance from a generator to its centroid, mesh units
  double mean_cell_radius = 0;                 ///< sqrt(area / (pi cells)), mesh units
};

/// Alternately balances the cells and moves every generator to the centroid of its cell, so that in the end cells have
/// their shares and generators are near their centroids. Ends with balanced cells. It works best with generators that
/// were relaxed before. After ten rounds, generators are within 1 % of the mean cell radius of their centroids on
/// smooth models, and within 20 % on thin ones; more rounds gain little.
/// Throws what `balance_cells` throws; Error{invalid_option} for a negative limit; Error{precondition} if the freedoms
/// do not fit the generators.
/// Cost: 3 to 5 diagrams for each round.
BalancedRelaxation relax_balanced(const Mesh& mesh, std::vector<SurfacePoint> generators,
                                  const BalancedRelaxationOptions& options = {});

}  // namespace gvd
