#include "remesh/relax_start.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/relaxation/relaxation_report.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

LloydOptions make_lloyd_options(Run& run, const ConstrainedStart& start, std::int32_t iterations) {
  LloydOptions options;
  options.max_iterations = iterations;
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  options.diagram = make_diagram_options(run.options().compute);
  options.progress = run.progress();
  options.on_iteration = [&run, iterations](std::int64_t done, double energy, const std::vector<SurfacePoint>&) {
    run.console().set_status(fmt::format("{}/{}, energy {:.6g}", done, iterations, energy));
  };
  return options;
}

void relax(Run& run, const Mesh& mesh, RelaxedStart& start, std::int32_t iterations) {
  std::vector<SurfacePoint>& points = start.constrained.points;
  const LloydOptions options = make_lloyd_options(run, start.constrained, iterations);
  LloydResult result = run.timed("relaxation", [&] { return relax_generators(mesh, points, options); });
  run.console().set_status("");
  run.console().detail(fmt::format("generators relaxed in {}, energy {:.6g} -> {:.6g} mesh units^4",
                                   counted(std::ssize(result.iterations), "iteration", "iterations"),
                                   result.initial_energy, result.final_energy));
  run.report().results()["relaxation"] = {{"iterations", result.iterations.size()},
                                          {"stop", name_of(result.stop)},
                                          {"initial_energy", result.initial_energy},
                                          {"final_energy", result.final_energy},
                                          {"diagrams", result.diagrams}};
  points = std::move(result.generators);
  start.diagram = std::move(result.diagram);
}

/// Those that are still where they were asked for keep their snap distances.
void report_generators(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<ReportedGenerator>& reported = run.report().generators();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i < reported.size() && reported[i].point == points[i]) continue;
    reported.resize(std::max(reported.size(), i + 1));
    reported[i] = {points[i], position(mesh, points[i]), std::nullopt};
  }
  reported.resize(points.size());
}

}  // namespace

RelaxedStart make_relaxed_start(Run& run, const CheckedMesh& input, const RelaxOptions& options) {
  const std::int32_t iterations = relax_iterations(options, run.options().generators);
  run.report().options()["relax"] = iterations;
  report_constraints(run.report().options(), options.constraints);
  run.report().results()["relaxation"] = nullptr;
  const GeneratorOptions& asked = run.options().generators;
  run.report().options()["target_edge"] = asked.target_edge ? nlohmann::ordered_json(*asked.target_edge) : nullptr;
  run.report().options()["loose_boundary"] = options.loose_boundary;
  ConstraintOptions constraints = options.constraints;
  constraints.prefers_boundary = !options.loose_boundary;
  RelaxedStart start{make_start(run, input, constraints), std::nullopt};
  if (iterations > 0) relax(run, input.mesh, start, iterations);
  report_generators(run, input.mesh, start.constrained.points);
  return start;
}

}  // namespace gvd::app
