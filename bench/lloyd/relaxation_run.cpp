#include "relaxation_run.hpp"

#include <utility>

#include "cpu_clock.hpp"
#include "gvd/mesh.hpp"
#include "median.hpp"

namespace gvd::bench {
namespace {

/// The factor that makes E of an energy.
double energy_scale(const Mesh& mesh, std::size_t generators) {
  const double area = compute_area(mesh);
  return static_cast<double>(generators) / (area * area);
}

}  // namespace

double scaled_energy(const Mesh& mesh, const Diagram& diagram) {
  double energy = 0;
  for (const CellMoments& cell : compute_cell_moments(mesh, diagram, 1)) energy += cell.energy;
  return energy * energy_scale(mesh, diagram.generators.size());
}

RelaxationRun run_relaxation(const Mesh& mesh, const std::vector<SurfacePoint>& generators, LloydOptions options) {
  RelaxationRun run;
  const double scale = energy_scale(mesh, generators.size()), start = cpu_milliseconds();
  options.diagram.threads = 1;
  options.on_iteration = [&](std::int64_t iteration, double energy, const std::vector<SurfacePoint>&) {
    run.trace.push_back({static_cast<int>(iteration), (cpu_milliseconds() - start) / 1e3, energy * scale});
  };
  run.result = relax_generators(mesh, generators, options);
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
