#pragma once

#include <cstddef>
#include <vector>

#include "constraints.hpp"
#include "gvd/lloyd.hpp"
#include "measured_cells.hpp"
#include "optimiser.hpp"
#include "vertex_rests.hpp"

namespace gvd {

/// How the cells of generators are found. Energies of different precisions must not be compared with each other,
/// because they differ by the errors at the bisectors.
struct Precision {
  DiagramOptions diagram;
  bool skips_diagram = false;  ///< measure the cells face by face instead (see measured_cells.cpp)
  /// Generators at vertices rest if their way to the centroid is at most this fraction of the mean cell radius, >= 0.
  double rest_tolerance = 0;
};

/// Generators, their cells, and the integrals over these.
struct RelaxationState {
  std::vector<SurfacePoint> generators;
  Diagram diagram;  ///< empty if the precision skips it
  IdVector<GeneratorId, CellMoments> moments;
  CellGeometry geometry;
  double energy = 0;
  /// The vectors to the centroids, projected onto allowed directions; at a vertex the vector of steepest descent. Mesh
  /// units.
  TangentField to_centroids;
  double residual = 0;  ///< length of the longest of these vectors
  /// For each generator, whether it is at a vertex where short steps do not lower the energy of its cell, or hardly.
  std::vector<char> is_resting;
  Rests rest;
  double mean_cell_radius = 0;  ///< sqrt(area / (pi cells)), mesh units
};

/// Whether the energy is not a smooth function of the generator, because it is at a vertex or goes to rest at one. The
/// steps of other generators then tell nothing about its own, and it takes Lloyd's step.
inline bool is_at_kink(const RelaxationState& state, const Rests& rests, std::size_t i) {
  return state.is_resting[i] || rests[i] || state.generators[i].kind() == SurfacePoint::Kind::vertex;
}

/// Computes the cells, integrals and vectors to the centroids of these generators.
RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const Precision& precision, const Density& density = {},
                                    const GeneratorConstraints& constraints = {});

/// The gradient of the energy: -2 mass centroid for each generator; mesh units cubed.
TangentField energy_gradient(const RelaxationState& state);

/// Twice the integrals of the density over the cells. The gradient divided by them is minus the vector to the centroid,
/// so Lloyd's step is the step of a Newton method with this diagonal Hessian. A cell without mass gets the mean.
std::vector<double> cell_masses(const RelaxationState& state);

}  // namespace gvd
