// Relaxations with their times and energies, and a flat square whose best energy is known.
//
// E is energy / (area^2 / m), from exact distances; a honeycomb has 0.16038. E has no unit and hardly depends on m, so
// that meshes and numbers of generators compare. Curvature moves it: a closed surface other than a torus needs cells
// that are no hexagons. The times of a run include its last, exact diagram, but not the drawing of the generators.
// Early iterations have approximate energies; the runs that are timed are ended at an iteration and measured exactly.
// Near its boundary the square's cells are others than in a honeycomb, so only interior cells count.
#include "relaxation_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "clocks.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"

namespace gvd::bench {

Mesh make_flat_square(int n) {
  std::vector<Vec3> positions;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) positions.emplace_back(i, j, 0);
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
      faces.push_back({VertexId(a), VertexId(c), VertexId(d)});
    }
  }
  return Mesh(std::move(positions), std::move(faces));
}

InteriorEnergy interior_energy(const Mesh& square, int n, const Diagram& diagram, double margin) {
  const IdVector<GeneratorId, CellMoments> moments = compute_cell_moments(square, diagram, 1);
  const double least = margin * n / std::sqrt(double(moments.size()));
  InteriorEnergy interior;
  double area = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Vec3 p = position(square, diagram.generators[i]);
    if (std::min({p.x(), p.y(), n - p.x(), n - p.y()}) < least) continue;
    const CellMoments& cell = moments[GeneratorId(i)];
    ++interior.cells;
    interior.energy += cell.energy;
    area += cell.area;
  }
  if (area > 0) interior.energy *= interior.cells / (area * area);
  return interior;
}

namespace {

/// The factor that makes E of an energy.
double energy_scale(const Mesh& mesh, std::size_t generators) {
  const double area = compute_area(mesh);
  return double(generators) / (area * area);
}

}  // namespace

double scaled_energy(const Mesh& mesh, const Diagram& diagram) {
  double energy = 0;
  for (const CellMoments& cell : compute_cell_moments(mesh, diagram, 1)) energy += cell.energy;
  return energy * energy_scale(mesh, diagram.generators.size());
}

RelaxationRun run_relaxation(const Mesh& mesh, const std::vector<SurfacePoint>& generators, LloydOptions options,
                             const LloydStages& stages) {
  RelaxationRun run;
  const double scale = energy_scale(mesh, generators.size()), start = cpu_milliseconds();
  options.diagram.threads = 1;
  options.on_iteration = [&](std::int64_t iteration, double energy, const std::vector<SurfacePoint>&) {
    run.trace.push_back({static_cast<int>(iteration), (cpu_milliseconds() - start) / 1e3, energy * scale});
  };
  run.result = relax_generators(mesh, generators, options, stages);
  run.seconds = (cpu_milliseconds() - start) / 1e3;
  run.energy = scaled_energy(mesh, run.result.diagram);
  return run;
}

std::optional<ShortestRun> shortest_run_to(double energy, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                           const std::vector<TracePoint>& trace, int runs) {
  // Early energies are off by about 2e-5, so the iteration before may already do.
  auto point = trace.begin();
  while (point != trace.end() && point->energy > energy + 5e-5) ++point;
  if (point == trace.end()) return std::nullopt;
  for (int iterations = point->iteration; iterations <= trace.back().iteration; ++iterations) {
    LloydOptions options;
    options.max_iterations = iterations;
    RelaxationRun run = run_relaxation(mesh, generators, options);
    if (run.energy > energy) continue;
    std::vector<double> seconds{run.seconds};
    while (std::ssize(seconds) < runs) seconds.push_back(run_relaxation(mesh, generators, options).seconds);
    return ShortestRun{iterations, median(std::move(seconds)), run.energy};
  }
  return std::nullopt;
}

}  // namespace gvd::bench
