#include "relaxation_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel_chunks.hpp"
#include "diagram/diagram_windows.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "integrals/window_integrals.hpp"

namespace gvd {
namespace {

/// With the log map that a march over the faces of each cell gives.
void march_moments(CellIntegrals& integrals, RelaxationState& state) {
  const CellFaces cells(state.diagram);
  for (const SurfacePoint& generator : state.generators) {
    const GeneratorId g(static_cast<std::int64_t>(state.moments.size()));
    state.moments.push_back(integrals.compute(generator, cells.of(g)));
  }
}

void add_sums(const Mesh& mesh, const GeneratorConstraints& constraints, RelaxationState& state) {
  state.is_resting.assign(state.generators.size(), 0);
  double area = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const GeneratorId g(static_cast<std::int64_t>(i));
    state.energy += state.moments[g].energy;
    area += state.moments[g].area;
    state.to_centroids.push_back(constraints.project(mesh, i, state.generators[i], state.moments[g].centroid));
    state.residual = std::max(state.residual, state.to_centroids.back().norm());
  }
  state.mean_cell_radius = std::sqrt(area / (std::numbers::pi * static_cast<double>(state.generators.size())));
}

}  // namespace

RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const DiagramOptions& options, CellIntegrals& integrals,
                                    const GeneratorConstraints& constraints) {
  RelaxationState state;
  state.generators = generators;
  if (options.method == Method::exact) {
    const ParallelChunks parallel(options.threads, options.progress);
    const auto read = [&](const WorkingMesh& working, const WindowField& field, const Diagram& diagram) {
      state.moments = integrate_over_windows(working, field, diagram, {integrals.density()}, parallel);
    };
    state.diagram = compute_diagram_and_read(mesh, generators, options, read);
  } else {
    state.diagram = compute_diagram(mesh, generators, options);
    march_moments(integrals, state);
  }
  add_sums(mesh, constraints, state);
  return state;
}

TangentField energy_gradient(const RelaxationState& state) {
  TangentField gradient = state.to_centroids;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] *= -2 * state.moments[GeneratorId(static_cast<std::int64_t>(i))].mass;
  }
  return gradient;
}

std::vector<double> cell_masses(const RelaxationState& state) {
  std::vector<double> masses;
  double sum = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    masses.push_back(2 * state.moments[GeneratorId(static_cast<std::int64_t>(i))].mass);
    sum += masses.back();
  }
  const double mean = sum > 0 ? sum / static_cast<double>(masses.size()) : 1;
  for (double& mass : masses) {
    if (!(mass > 0)) mass = mean;
  }
  return masses;
}

}  // namespace gvd
