#include "relaxation_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "diagram/diagram_windows.hpp"
#include "gvd/mesh.hpp"
#include "integrals/measured_cells.hpp"
#include "integrals/window_integrals.hpp"
#include "state/vertex_rests.hpp"

namespace gvd {
namespace {

/// Greatest distance from a saddle vertex from which a generator goes to rest there, in mean cell radii: farther away,
/// the paths of the generator tell too little about those from the vertex.
constexpr double kReach = 0.1;

double mean_radius(double area, std::size_t cells) {
  return std::sqrt(area / (std::numbers::pi * static_cast<double>(cells)));
}

/// The cells of a diagram.
CellIntegrals integrate_diagram(const Mesh& mesh, const Precision& precision, const Quadrature& quadrature,
                                RelaxationState& state) {
  const DiagramOptions& options = precision.diagram;
  CellIntegrals integrals;
  if (options.method == Method::exact) {
    const ParallelChunks parallel(options.threads, options.progress);
    const auto read = [&](const WorkingMesh& working, const WindowField& field, const Diagram& diagram) {
      integrals = integrate_over_windows(working, field, diagram, quadrature, parallel);
    };
    state.diagram = compute_diagram_and_read(mesh, state.generators, options, read);
  } else {
    state.diagram = compute_diagram(mesh, state.generators, options);
    integrals = integrate_cells(mesh, state.diagram, quadrature, options.threads);
  }
  state.segments = bisector_segments(mesh, state.diagram, quadrature.density);
  state.vertex_distance = state.diagram.vertex_distance;
  return integrals;
}

/// The cells without a diagram.
CellIntegrals integrate_faces(const Mesh& mesh, const Precision& precision, const Quadrature& quadrature,
                              RelaxationState& state) {
  MeasuredCells cells =
      measure_cells(mesh, state.generators, {quadrature.density, quadrature.watched, precision.diagram.threads},
                    precision.diagram.progress);
  state.segments = std::move(cells.segments);
  state.vertex_distance = std::move(cells.vertex_distance);
  return std::move(cells.integrals);
}

/// When generators rest at vertices: distances in mesh units.
struct RestRules {
  double reach;      // to the vertex
  double tolerance;  // length of the way from the vertex
};

/// Where the generators would go.
void add_ways(const Mesh& mesh, const GeneratorConstraints& constraints, const std::vector<PathSample>& samples,
              const RestRules& rules, RelaxationState& state) {
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    const GeneratorId g(i);
    const SurfacePoint& generator = state.generators[i];
    Vec2 way = state.moments[g].centroid;
    const bool is_at_vertex = generator.kind() == SurfacePoint::Kind::vertex && constraints.is_free(i);
    if (is_at_vertex) way = steepest_way(mesh, generator, samples_of(samples, g), state.moments[g].mass, way);
    state.to_centroids.push_back(constraints.project(mesh, i, generator, way));
    state.residual = std::max(state.residual, state.to_centroids.back().norm());
    state.is_resting.push_back(is_at_vertex && way.norm() <= rules.tolerance);
    state.rest.push_back(constraints.is_free(i) ? find_rest(mesh, generator, way, rules.reach, samples_of(samples, g))
                                                : std::nullopt);
  }
}

}  // namespace

RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const Precision& precision, const Density& density,
                                    const GeneratorConstraints& constraints) {
  RelaxationState state;
  state.generators = generators;
  const double reach = kReach * mean_radius(compute_area(mesh), generators.size());
  const WatchedGenerators watched = watch_generators(mesh, generators, reach);
  const Quadrature quadrature{density, watched};
  CellIntegrals integrals = precision.skips_diagram ? integrate_faces(mesh, precision, quadrature, state)
                                                    : integrate_diagram(mesh, precision, quadrature, state);
  state.moments = std::move(integrals.moments);
  double area = 0;
  for (const CellMoments& cell : state.moments) {
    state.energy += cell.energy;
    area += cell.area;
  }
  state.mean_cell_radius = mean_radius(area, generators.size());
  const RestRules rules{reach, precision.rest_tolerance * state.mean_cell_radius};
  add_ways(mesh, constraints, integrals.samples, rules, state);
  return state;
}

TangentField energy_gradient(const RelaxationState& state) {
  TangentField gradient = state.to_centroids;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] *= -2 * state.moments[GeneratorId(i)].mass;
  }
  return gradient;
}

std::vector<double> cell_masses(const RelaxationState& state) {
  std::vector<double> masses;
  double sum = 0;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    masses.push_back(2 * state.moments[GeneratorId(i)].mass);
    sum += masses.back();
  }
  const double mean = sum > 0 ? sum / static_cast<double>(masses.size()) : 1;
  for (double& mass : masses) {
    if (!(mass > 0)) mass = mean;
  }
  return masses;
}

}  // namespace gvd
