// Computes states of a relaxation: generators with their cells, the energy, and the vectors to the centroids.
//
// The vector to the centroid is projected onto the directions in which the generator may move; at a vertex, the
// direction of steepest descent replaces it (vertex_rests.hpp). Sums run in ascending order of the generators.
#include "relaxation_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/plane.hpp"
#include "diagram/diagram_windows.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/geodesic_tracing.hpp"

namespace gvd {
namespace {

/// Largest distance, in mean cell radii, from which a generator goes to rest at a saddle vertex. From farther away, the
/// paths of the generator tell too little about the paths from the vertex.
constexpr double kReach = 0.1;

/// The radius of a disc with the mean area of the cells.
double mean_radius(double area, std::size_t cells) { return std::sqrt(area / (std::numbers::pi * double(cells))); }

/// Computes the diagram of the state, and integrates over its cells.
CellIntegrals integrate_diagram(const Mesh& mesh, const Precision& precision, const Integrand& integrand,
                                RelaxationState& state) {
  const DiagramOptions& options = precision.diagram;
  CellIntegrals integrals;
  const ParallelChunks parallel(options.threads, options.progress);
  const auto read = [&](const WorkingMesh& working, const WindowField& field, const Diagram& diagram) {
    integrals = integrate_over_windows(working, field, diagram, {integrand}, parallel);
    state.geometry = find_geometry(working, field, diagram.generators, integrand.density, parallel);
  };
  if (options.method == Method::exact) {
    state.diagram = compute_diagram_and_read(mesh, state.generators, options, KeepWindows::all, read);
  } else {
    state.diagram = compute_diagram(mesh, state.generators, options);
    PropagationOptions propagation;
    propagation.threads = options.threads;
    read_windows(mesh, state.generators, propagation, options.progress,
                 [&](const WorkingMesh& working, const WindowField& field) { read(working, field, state.diagram); });
  }
  return integrals;
}

/// Integrates over the cells without a diagram.
CellIntegrals integrate_faces(const Mesh& mesh, const Precision& precision, const Integrand& integrand,
                              RelaxationState& state) {
  MeasuredCells cells =
      measure_cells(mesh, state.generators, integrand, precision.diagram.threads, precision.diagram.progress);
  state.geometry = std::move(cells.geometry);
  return std::move(cells.integrals);
}

}  // namespace

RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const Precision& precision, const Density& density,
                                    const GeneratorConstraints& constraints) {
  RelaxationState state;
  state.generators = generators;
  const double reach = kReach * mean_radius(compute_area(mesh), generators.size());
  const WatchedGenerators watched = watch_generators(mesh, generators, reach);
  const Integrand integrand{density, watched};
  CellIntegrals integrals = precision.skips_diagram ? integrate_faces(mesh, precision, integrand, state)
                                                    : integrate_diagram(mesh, precision, integrand, state);
  state.moments = std::move(integrals.moments);
  double area = 0;
  for (const CellMoments& cell : state.moments) {
    state.energy += cell.energy;
    area += cell.area;
  }
  state.mean_cell_radius = mean_radius(area, generators.size());
  for (const GeneratorId g : state.moments.ids()) {
    const std::size_t i = g.index();
    const SurfacePoint& generator = generators[i];
    const std::span<const PathSample> samples = samples_of(integrals.samples, g);
    Vec2 way = state.moments[g].centroid;
    const bool is_at_vertex = generator.kind() == SurfacePoint::Kind::vertex && constraints.is_free(i);
    if (is_at_vertex) way = steepest_way(mesh, generator, samples, state.moments[g].mass, way);
    state.to_centroids.push_back(constraints.project(mesh, i, generator, way));
    state.residual = std::max(state.residual, state.to_centroids.back().norm());
    state.is_resting.push_back(is_at_vertex && way.norm() <= precision.rest_tolerance * state.mean_cell_radius);
    state.rest.push_back(constraints.is_free(i) ? find_rest(mesh, generator, way, reach, samples) : std::nullopt);
  }
  return state;
}

TangentField energy_gradient(const RelaxationState& state) {
  TangentField gradient = state.to_centroids;
  for (const GeneratorId g : state.moments.ids()) gradient[g.index()] *= -2 * state.moments[g].mass;
  return gradient;
}

std::vector<double> cell_masses(const RelaxationState& state) {
  std::vector<double> masses;
  double sum = 0;
  for (const CellMoments& cell : state.moments) {
    masses.push_back(2 * cell.mass);
    sum += masses.back();
  }
  const double mean = sum > 0 ? sum / double(masses.size()) : 1;
  for (double& mass : masses) {
    if (!(mass > 0)) mass = mean;
  }
  return masses;
}

}  // namespace gvd
