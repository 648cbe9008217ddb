// States of a relaxation: generators with their cells, the energy, and the ways to the centroids.
//
// Early levels of precision measure the cells without diagrams; the last one has those that the caller asked for.
// Energies of one level are compared with each other only: between levels they differ by the errors at the bisectors.
// A way leads to the centroid, projected to where the generator may go. At a vertex it is the steepest way instead,
// because the energy has no gradient there (vertex_rests.hpp). Sums run in ascending order of the generators.
#include "relaxation_state.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>

#include "diagram/diagram_windows.hpp"
#include "gvd/diagram_steps.hpp"
#include "vertex_rests.hpp"

namespace gvd {
namespace {

/// Greatest distance from a saddle vertex from which a generator goes to rest there, in mean cell radii: farther away,
/// the paths of the generator tell too little about those from the vertex.
constexpr double kReach = 0.1;

/// Chord tolerance of the last but one level, in mean edge lengths. A diagram takes 5 to 10 % less time than with 1e-4.
/// The energy rises with the square of the tolerance, for the true bisector is the best one.
constexpr double kCoarseChords = 0.05;

/// The radius of a disc with the mean area of the cells.
double mean_radius(double area, std::size_t cells) { return std::sqrt(area / (std::numbers::pi * double(cells))); }

/// Integrates over the cells of a diagram, which becomes that of the state.
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

/// Integrates over the cells without a diagram.
CellIntegrals integrate_faces(const Mesh& mesh, const Precision& precision, const Quadrature& quadrature,
                              RelaxationState& state) {
  MeasuredCells cells =
      measure_cells(mesh, state.generators, {quadrature.density, quadrature.watched, precision.diagram.threads},
                    precision.diagram.progress);
  state.segments = std::move(cells.segments);
  state.vertex_distance = std::move(cells.vertex_distance);
  return std::move(cells.integrals);
}

/// Distances at which generators rest at vertices, mesh units.
struct RestRules {
  double reach;      // to the vertex
  double tolerance;  // length of the way from the vertex
};

/// Adds the ways of the generators, and the vertices at which they rest or would rest.
void add_ways(const Mesh& mesh, const GeneratorConstraints& constraints, const std::vector<PathSample>& samples,
              const RestRules& rules, RelaxationState& state) {
  for (const GeneratorId g : state.moments.ids()) {
    const std::size_t i = g.index();
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

std::vector<Precision> make_precision_levels(const LloydOptions& options) {
  std::vector<Precision> levels;
  const bool starts_without_diagrams = options.early_approximation && max_iterations(options) > 0 &&
                                       options.acceleration != Acceleration::none &&
                                       options.diagram.method == Method::exact;
  if (starts_without_diagrams) {
    levels.assign(2, {options.diagram, false});
    levels[0].skips_diagram = true;
    levels[1].diagram.chord_tolerance = std::max(kCoarseChords, options.diagram.chord_tolerance);
  }
  levels.push_back({options.diagram, false});
  return levels;
}

RelaxationState StateEvaluator::evaluate(const std::vector<SurfacePoint>& generators,
                                         const std::function<void(double)>& report) {
  Precision precision = levels_[level_];
  precision.rest_tolerance = options_.move_tolerance;
  precision.diagram.progress = [&report](std::string_view step, double fraction) {
    const auto begun = std::find(steps::kAll.begin(), steps::kAll.end(), step) - steps::kAll.begin();
    report((double(begun) + fraction) / double(steps::kAll.size()));
    return true;
  };
  ++diagrams_;
  return evaluate_generators(mesh_, generators, precision, options_.density, constraints_);
}

}  // namespace gvd
