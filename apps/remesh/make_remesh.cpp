// The computing part of a run of gvd-remesh: generators, their relaxation, the remesh, and with --error their number.
//
// Sampled generators are relaxed first; listed ones stay where they are. The diagram of the relaxation's last iteration
// is that of the remesh. --error asks for the fewest generators whose remesh is near enough: trials by bisection
// (find_fewest), each a whole remesh in a run of its own that prints and reports nothing, and then the run itself. A
// trial that fails counts as infinitely far, unless no trial before it has succeeded: then larger ones would take long.

#include "remesh/make_remesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/relaxation.hpp"
#include "common/run_parts.hpp"
#include "gvd/counted.hpp"
#include "gvd/error.hpp"
#include "gvd/find_fewest.hpp"
#include "gvd/lloyd.hpp"
#include "remesh/remesh_report.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// The generators that a remesh begins with.
struct RelaxedStart {
  ConstrainedStart constrained;
  std::optional<Diagram> diagram;  ///< of the points, where a relaxation has computed it
};

void relax(Run& run, const Mesh& mesh, RelaxedStart& start, std::int32_t iterations) {
  LloydOptions options = make_lloyd_options({}, start.constrained, run.options().compute);
  options.max_iterations = iterations;
  options.progress = run.progress();
  options.on_iteration = [&run, iterations](std::int64_t done, double energy, const std::vector<SurfacePoint>&) {
    run.console().set_status(fmt::format("{}/{}, energy {:.6g}", done, iterations, energy));
  };
  LloydResult result =
      run.timed("relaxation", [&] { return relax_generators(mesh, start.constrained.points, options); });
  run.console().set_status("");
  run.console().detail(fmt::format("generators relaxed in {}, energy {:.6g} -> {:.6g} mesh units^4",
                                   counted(std::ssize(result.iterations), "iteration", "iterations"),
                                   result.initial_energy, result.final_energy));
  run.report().results()["relaxation"] = {{"iterations", result.iterations.size()},
                                          {"stop", name_of(result.stop)},
                                          {"initial_energy", result.initial_energy},
                                          {"final_energy", result.final_energy},
                                          {"diagrams", result.diagrams}};
  start.constrained.points = std::move(result.generators);
  start.diagram = std::move(result.diagram);
}

void report_start_options(Run& run, const RelaxOptions& options, std::int32_t iterations) {
  Json& reported = run.report().options();
  const GeneratorOptions& asked = run.options().generators;
  reported["relax"] = iterations;
  report_constraints(reported, options.constraints);
  reported["target_edge"] = asked.target_edge ? Json(*asked.target_edge) : nullptr;
  reported["loose_boundary"] = options.loose_boundary;
  run.report().results()["relaxation"] = nullptr;
}

/// The generators of the run, or as many as `count`, relaxed as the options say.
RelaxedStart make_start(Run& run, const CheckedMesh& input, const RelaxOptions& options,
                        std::optional<std::int32_t> count) {
  const std::int32_t iterations = relax_iterations(options, run.options().generators);
  report_start_options(run, options, iterations);
  ConstraintOptions constraints = options.constraints;
  constraints.prefers_boundary = !options.loose_boundary;
  RelaxedStart start{constrain_start(input, make_generators(run, input, count), constraints, run.options()), {}};
  const std::vector<Freedom>& freedom = start.constrained.freedom;
  if (!freedom.empty()) run.console().note(describe_freedom(freedom));
  if (iterations > 0) relax(run, input.mesh, start, iterations);
  run.report().set_generators(input.mesh, start.constrained.points);
  return start;
}

/// Listed generators are where the user wants the vertices.
Placement default_placement(const GeneratorOptions& generators) {
  return generators.are_listed() ? Placement::generator : PlacementOptions().method;
}

RemeshOptions remesh_options(Run& run, const Mesh& mesh, const ConstrainedStart& start, const Settings& settings) {
  RemeshOptions options = settings.remesh;
  options.creases = trace_creases(mesh, start.creases, start.corner_distance);
  options.placement.method = settings.place.value_or(default_placement(run.options().generators));
  for (std::size_t i = 0; i < start.freedom.size(); ++i) {
    if (start.freedom[i] == Freedom::fixed) options.placement.fixed.emplace_back(i);
  }
  if (!options.max_added) options.max_added = default_max_added(compute_mesh_summary(mesh), start.points.size());
  options.refine = !settings.no_refine;
  options.diagram = make_diagram_options(run.options().compute);
  options.diagram.progress = run.progress();
  for (const auto& [name, value] : placement_names()) {
    if (value == options.placement.method) run.report().options()["place"] = name;
  }
  report_remesh_options(run.report().options(), options);
  return options;
}

/// Remeshes, and reports the time of each stage.
RemeshResult timed_remesh(Run& run, const Mesh& mesh, RelaxedStart&& start, RemeshOptions options) {
  StepTimes times(run);
  options.on_stage = [&times](RemeshStage stage) {
    constexpr std::array<const char*, 5> kNames{"diagram", "dual", "placement", "search", "distance"};
    times.start(kNames[static_cast<std::size_t>(stage)]);
  };
  if (start.diagram) return remesh(mesh, std::move(*start.diagram), options);
  return remesh(mesh, start.constrained.points, options);
}

RemeshResult remesh_once(Run& run, const CheckedMesh& input, const Settings& settings,
                         std::optional<std::int32_t> count) {
  const Mesh& mesh = input.mesh;
  RelaxedStart start = make_start(run, input, settings.relaxation, count);
  const RemeshOptions options = remesh_options(run, mesh, start.constrained, settings);
  RemeshResult result = timed_remesh(run, mesh, std::move(start), options);
  report_remesh(run.report().results(), mesh, result);
  run.report().set_diagram(result.diagram);
  run.figures().regions = std::ssize(result.diagram.cells);
  run.report().set_generators(mesh, result.generators);
  for (const std::string& line : describe_remesh(result, options)) run.console().note(line);
  return result;
}

/// Distances of remeshes, infinite where a number of generators gives none.
class Trials {
 public:
  Trials(const CheckedMesh& input, const Settings& settings) : input_(input), settings_(settings) {}

  /// The distance of the remesh with `count` generators. Infinite where these are fewer than fixed generators and
  /// features, or too few for a valid mesh while none may be added. Throws Error{no_valid_result} until a trial has
  /// given a mesh: larger trials of an input that has no remesh would take long.
  double distance(const Options& options, std::int32_t count) {
    Console silent("", {}, true, false);
    Run trial("", options, silent);
    try {
      const RemeshResult result = remesh_once(trial, input_, settings_, count);
      has_result_ = true;
      return std::max(result.input_to_output.hausdorff, result.output_to_input.hausdorff);
    } catch (const Error& error) {
      const bool too_few = error.code() == ErrorCode::no_valid_result && has_result_;
      if (error.code() != ErrorCode::precondition && !too_few) throw;
      last_failure_ = std::current_exception();
      return std::numeric_limits<double>::infinity();
    }
  }

  [[noreturn]] void refuse(double target, const Fewest& found) const {
    const auto by_error = [](const CountTrial& a, const CountTrial& b) { return a.error < b.error; };
    const CountTrial& best = *std::min_element(found.trials.begin(), found.trials.end(), by_error);
    if (!std::isfinite(best.error)) std::rethrow_exception(last_failure_);
    throw Error(
        ErrorCode::no_valid_result,
        fmt::format("--error: no mesh of up to {} generators is within {:.6g} mesh units of the input; the nearest "
                    "is within {:.6g}; ask for that or more",
                    found.trials.back().count, target, best.error));
  }

 private:
  const CheckedMesh& input_;
  const Settings& settings_;
  bool has_result_ = false;
  std::exception_ptr last_failure_;
};

FewestOptions search_options(const Mesh& mesh, const ErrorBound& bound) {
  constexpr std::int64_t kMostPerVertex = 4;  // most generators that are tried, for each vertex of the input
  constexpr std::int64_t kLeastMost = 2000;   // for meshes with few vertices
  FewestOptions options;
  options.target = bound.value * (bound.in_diagonals ? mesh.bbox_diagonal() : 1);
  options.most =
      static_cast<std::int32_t>(std::clamp<std::int64_t>(kMostPerVertex * mesh.vertex_count(), kLeastMost, 1000000000));
  return options;
}

/// Searches for the fewest generators that keep the distance of `--error`, and reports the trials.
std::int32_t search_count(Run& run, const CheckedMesh& input, const Settings& settings) {
  const FewestOptions options = search_options(input.mesh, *run.options().generators.error);
  Trials trials(input, settings);
  double done = 0;
  const auto try_count = [&](std::int32_t count) {
    run.console().set_status(fmt::format("{} generators", count));
    report_progress(run.progress(), "search", done++ / options.max_trials);
    const double distance = trials.distance(run.options(), count);
    run.console().detail(std::isfinite(distance)
                             ? fmt::format("{} generators: distance {:.6g} mesh units", count, distance)
                             : fmt::format("{} generators: no mesh", count));
    return distance;
  };
  const Fewest found = run.timed("trials", [&] { return find_fewest(options, try_count); });
  run.console().set_status("");
  report_trials(run.report().results(), options.target, found);
  if (!found.count) trials.refuse(options.target, found);
  return *found.count;
}

}  // namespace

const std::vector<std::pair<std::string, Placement>>& placement_names() {
  static const std::vector<std::pair<std::string, Placement>> names{
      {"generator", Placement::generator}, {"quadric", Placement::quadric}, {"fit", Placement::fit}};
  return names;
}

RemeshResult make_remesh(Run& run, const CheckedMesh& input, const Settings& settings) {
  std::optional<std::int32_t> count;
  if (run.options().generators.error) count = search_count(run, input, settings);
  return remesh_once(run, input, settings, count);
}

}  // namespace gvd::app
