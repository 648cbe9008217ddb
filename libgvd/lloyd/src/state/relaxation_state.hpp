#pragma once

#include <vector>

#include "constraints/generator_constraints.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/diagram.hpp"
#include "integrals/cell_integrals.hpp"
#include "optimiser/tangent_field.hpp"

namespace gvd {

/// Generators, their diagram, and the integrals over its cells.
struct RelaxationState {
  std::vector<SurfacePoint> generators;
  Diagram diagram;
  IdVector<GeneratorId, CellMoments> moments;
  double energy = 0;
  /// The ways to the centroids, projected to where the generators may go; mesh units.
  TangentField to_centroids;
  double residual = 0;  ///< length of the longest way
  /// Whether each generator is at a vertex where every short step raises the energy of its cell. Its way is then zero.
  std::vector<char> is_resting;
  double mean_cell_radius = 0;  ///< sqrt(area / (pi cells)), mesh units
};

/// Diagram, integrals and ways to the centroids of these generators.
RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const DiagramOptions& options, CellIntegrals& integrals,
                                    const GeneratorConstraints& constraints = {});

/// The gradient of the energy: -2 mass centroid for each generator; mesh units cubed.
TangentField energy_gradient(const RelaxationState& state);

/// Twice the integrals of the density over the cells. The gradient divided by them is minus the way to the centroid, so
/// Lloyd's step is the step of a Newton method with this diagonal Hessian. A cell without any takes the mean.
std::vector<double> cell_masses(const RelaxationState& state);

}  // namespace gvd
