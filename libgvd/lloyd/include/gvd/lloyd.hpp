#pragma once

#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Integrals over one cell.
struct CellMoments {
  double area = 0;    ///< square mesh units
  double energy = 0;  ///< integral of the squared distance to the generator, mesh units to the fourth
  /// Mean of the log map at the generator: the tangent vector to the cell's centroid, mesh units (see
  /// geodesic_tracing.hpp). The energy's gradient with respect to the generator is -2 area centroid.
  Vec2 centroid = Vec2::Zero();
};

/// Integrals over every cell of a diagram.
///
/// Quadrature: over each triangle of a face's pieces the squared distance is the quadratic that its three corner
/// distances and edge lengths give, d^2 = sum b_i d_i^2 - sum b_i b_j l_ij^2, and the log map is linear; both are
/// integrated exactly. Where the straight lines from the generator stay in the cell and no vertex bends them, that is
/// the integral itself. Distances and directions are those of `LogMapSolver` over the faces of the cell. Throws
/// Error{precondition} where the diagram was not made of this mesh. Cost: O(n log n).
IdVector<GeneratorId, CellMoments> compute_cell_moments(const Mesh& mesh, const Diagram& diagram);

struct LloydOptions {
  std::int32_t max_iterations = 100;  ///< >= 0
  /// Stop once an iteration lowers the energy by less than this part of it. >= 0.
  double energy_tolerance = 1e-5;
  /// Stop once no centroid is farther from its generator than this part of the mean cell radius sqrt(area / (pi
  /// cells)).
  /// >= 0.
  double move_tolerance = 1e-3;
  /// How far a generator goes towards its centroid: 1 is Lloyd's step, more overrelaxes. In (0, 2).
  double step = 1;
  DiagramOptions diagram;  ///< of every iteration; its progress callback is not used
  Progress progress;       ///< may be empty
};

/// Why a relaxation ended.
enum class LloydStop {
  centroids,       ///< every generator is at its centroid, within move_tolerance
  energy,          ///< the last iteration lowered the energy by less than energy_tolerance
  no_descent,      ///< no step towards the centroids lowers the energy any more
  max_iterations,  ///< max_iterations were made
};

/// One iteration that lowered the energy.
struct LloydIteration {
  double energy = 0;        ///< after it, mesh units to the fourth
  double largest_move = 0;  ///< longest way of a generator, mesh units
  double mean_move = 0;     ///< mesh units
  double scale = 1;         ///< part of the step that was taken: 1, or less after halving
  std::int32_t held = 0;    ///< generators that stayed: no step lowers their cell's energy, or they would have collided
};

struct LloydResult {
  std::vector<SurfacePoint> generators;
  Diagram diagram;            ///< of these generators
  double initial_energy = 0;  ///< mesh units to the fourth
  double final_energy = 0;
  double residual = 0;  ///< largest distance from a generator to its centroid, mesh units
  double mean_cell_radius = 0;
  std::vector<LloydIteration> iterations;
  std::int64_t diagrams = 0;  ///< diagrams computed in all, those of rejected steps included
  LloydStop stop = LloydStop::no_descent;
};

/// Moves generators to the geodesic centroids of their cells, all at once, again and again (Lloyd's method).
///
/// Each generator walks the straight geodesic along the mean of its cell's log map; at the boundary it stops, and from
/// a boundary point an outward step slides along the boundary. An iteration counts only if it lowers the energy. If the
/// full step does not, each generator first halves its own step until its cell's energy, with the cell kept fixed,
/// falls; then all steps are halved together. A generator that would come to lie on another one stays where it is.
/// Properties: (1) the energies of the iterations fall; (2) every generator is a point of the surface, of the component
/// that it started in; (3) no two coincide; (4) deterministic.
/// Throws Error{invalid_option} for an option out of its range, Error{precondition} where `compute_diagram` does, and
/// Error{interrupted} where the progress callback cancels. Cost: one diagram and O(n log n) an iteration.
LloydResult relax_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const LloydOptions& options = {});

}  // namespace gvd
