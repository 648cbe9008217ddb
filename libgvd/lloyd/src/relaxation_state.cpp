#include "relaxation_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gvd/geodesic_tracing.hpp"

namespace gvd {
namespace {

void add_moments(const Mesh& mesh, CellIntegrals& integrals, RelaxationState& state) {
  const CellFaces cells(state.diagram);
  state.moments.resize(state.generators.size());
  state.is_resting.assign(state.generators.size(), 0);
  double area = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const GeneratorId g(static_cast<std::int64_t>(i));
    state.moments[g] = integrals.compute(state.generators[i], cells.of(g));
    state.energy += state.moments[g].energy;
    area += state.moments[g].area;
    state.to_centroids.push_back(project_to_surface(mesh, state.generators[i], state.moments[g].centroid));
    state.residual = std::max(state.residual, state.to_centroids.back().norm());
  }
  state.mean_cell_radius = std::sqrt(area / (std::numbers::pi * static_cast<double>(state.generators.size())));
}

}  // namespace

RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const DiagramOptions& options, CellIntegrals& integrals) {
  RelaxationState state;
  state.generators = generators;
  state.diagram = compute_diagram(mesh, generators, options);
  add_moments(mesh, integrals, state);
  return state;
}

TangentField energy_gradient(const RelaxationState& state) {
  TangentField gradient = state.to_centroids;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] *= -2 * state.moments[GeneratorId(static_cast<std::int64_t>(i))].area;
  }
  return gradient;
}

std::vector<double> cell_masses(const RelaxationState& state) {
  std::vector<double> masses;
  double sum = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    masses.push_back(2 * state.moments[GeneratorId(static_cast<std::int64_t>(i))].area);
    sum += masses.back();
  }
  const double mean = sum > 0 ? sum / static_cast<double>(masses.size()) : 1;
  for (double& mass : masses) {
    if (!(mass > 0)) mass = mean;
  }
  return masses;
}

}  // namespace gvd
