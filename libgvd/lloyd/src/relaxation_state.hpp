#pragma once

#include <cstddef>
#include <vector>

#include "constraints.hpp"
#include "gvd/lloyd.hpp"
#include "measured_cells.hpp"
#include "optimiser.hpp"
#include "vertex_rests.hpp"

namespace gvd {

/// How the cells of generators are found. Energies of different precisions must not be compared with each other: they
/// differ by the errors at the bisectors.
struct Precision {
  DiagramOptions diagram;
  bool skips_diagram = false;  ///< measures the cells face by face instead (see measured_cells.cpp)
  /// Generators at vertices rest if their way is at most this fraction of the mean cell radius, >= 0.
  double rest_tolerance = 0;
};

/// Generators, their cells, and the integrals over these.
struct RelaxationState {
  std::vector<SurfacePoint> generators;
  Diagram diagram;  ///< empty if the precision skips it
  IdVector<GeneratorId, CellMoments> moments;
  CellGeometry geometry;
  double energy = 0;
  /// The ways to the centroids, projected to where the generators may go; at a vertex the steepest way. Mesh units.
  TangentField to_centroids;
  double residual = 0;  ///< length of the longest way
  /// Whether each generator is at a vertex where no short step, or hardly any, lowers the energy of its cell.
  std::vector<char> is_resting;
  Rests rest;
  double mean_cell_radius = 0;  ///< sqrt(area / (pi cells)), mesh units
};

/// Whether the energy is no smooth function of the generator: it is at a vertex, or goes to rest at one. The steps of
/// other generators then tell nothing about its own, and it takes Lloyd's.
inline bool is_at_kink(const RelaxationState& state, const Rests& rests, std::size_t i) {
  return state.is_resting[i] || rests[i] || state.generators[i].kind() == SurfacePoint::Kind::vertex;
}

/// Cells, integrals and ways to the centroids of these generators.
RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const Precision& precision, const Density& density = {},
                                    const GeneratorConstraints& constraints = {});

/// The gradient of the energy: -2 mass centroid for each generator; mesh units cubed.
TangentField energy_gradient(const RelaxationState& state);

/// Twice the integrals of the density over the cells. The gradient divided by them is minus the way to the centroid, so
/// Lloyd's step is the step of a Newton method with this diagonal Hessian. A cell without any takes the mean.
std::vector<double> cell_masses(const RelaxationState& state);

}  // namespace gvd
