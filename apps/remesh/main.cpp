// gvd-remesh: builds the coarse mesh that is dual to a diagram.
//
// Sampled generators are relaxed first; listed ones stay where they are. The diagram of the relaxation's last iteration
// is that of the remesh. --error asks for the fewest generators whose remesh is near enough: trials by
// find_fewest, each a whole remesh in a run of its own that prints and reports nothing, and then the run itself. A
// trial that fails counts as infinitely far, unless no trial before it has succeeded: then larger ones would take long.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/command.hpp"
#include "common/options/options.hpp"
#include "common/process.hpp"
#include "common/relaxation.hpp"
#include "common/run_parts.hpp"
#include "gvd/carry_properties.hpp"
#include "gvd/error.hpp"
#include "gvd/find_fewest.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_scenes.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#include "remesh/remesh_report.hpp"
#include "remesh/settings.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExamples =
    "  gvd-remesh bunny.obj -n 2000 -o coarse.obj\n"
    "  gvd-remesh part.stl --features 40 --error 0.5% -o coarse.obj\n"
    "  gvd-remesh bunny.obj -n 2000 --relax 40 --density curvature -o coarse.ply\n"
    "  gvd-remesh bunny.obj --generators samples.json -o coarse.ply\n"
    "  gvd-remesh bunny.obj -n 500 --view coarse.html --report report.json\n"
    "  gvd-remesh bunny.obj -n 500 --no-refine -o coarse.off\n"
    "  gvd-remesh scans/*.stl -n 500 --output-dir coarse --output-format obj\n";

constexpr const char* kMap = "--map";

/// With --exact-count, the fraction of the generators that may be exchanged before a start with fewer is tried.
constexpr double kFewExchanged = 0.03;

/// The fraction of the generators that a start has fewer where the exchange has not made enough room.
constexpr double kFewerStart = 0.2;

/// The generators that a remesh begins with.
struct RelaxedStart {
  WeightedStart constrained;
  std::optional<Diagram> diagram;  ///< of the points, where a relaxation has computed it
  std::int64_t diagrams = 0;       ///< that the relaxation has computed
};

/// Whether generators are on creases inside of the surface. They do not move on a copy.
bool follows_creases(const Mesh& mesh, const WeightedStart& start) {
  for (std::size_t i = 0; i < start.freedom.size(); ++i) {
    if (start.freedom[i] == Freedom::on_crease && !is_on_boundary(mesh, start.points[i])) return true;
  }
  return false;
}

/// Generators on the boundary do not move on a copy either. With a larger share of them a copy is a loss: of the
/// lion's 500 generators a tenth moves along the boundary, and H is 1.6 % of the diagonal with a copy, 1.2 % without.
/// The bunny has 4 of 100 there, and is as good with a copy.
constexpr double kMostOnBoundary = 0.08;

/// Whether a larger share of `count` generators would move along the boundary, if all are spread evenly. Three of each
/// loop are fixed.
bool has_long_boundary(const Mesh& mesh, std::int32_t count) {
  double length = 0;
  for (const EdgeId e : mesh.edges()) length += mesh.is_boundary(e) ? mesh.length(e) : 0;
  const double on_boundary = length / even_spacing(compute_area(mesh), count);
  return on_boundary - 3 * compute_mesh_summary(mesh).boundary_loops > kMostOnBoundary * count;
}

void relax(Run& run, const Mesh& mesh, RelaxedStart& start, std::int32_t iterations) {
  LloydOptions options;
  options.max_iterations = iterations;
  options.keeps_extremities = true;
  options.ends_on_copy = !follows_creases(mesh, start.constrained);
  LloydResult result = run_relaxation(run, mesh, start.constrained, std::move(options));
  run.console().detail(fmt::format("generators relaxed in {}, energy {:.6g} -> {:.6g} mesh units^4",
                                   counted(std::ssize(result.iterations), "iteration", "iterations"),
                                   result.initial_energy, result.final_energy));
  run.report().results()["relaxation"] = {
      {"iterations", result.iterations.size()},   {"stop", name_of(result.stop)},
      {"initial_energy", result.initial_energy},  {"final_energy", result.final_energy},
      {"extremities", result.extremities.size()}, {"diagrams", result.diagrams},
      {"coarse", describe_copy(result.copy)}};
  // A fit would pull the vertex at the end of a thin limb back, or push it too far out.
  std::vector<Freedom>& freedom = start.constrained.freedom;
  if (!result.extremities.empty()) freedom.resize(result.generators.size(), Freedom::free);
  for (const GeneratorId g : result.extremities) freedom[g.index()] = Freedom::fixed;
  start.constrained.points = std::move(result.generators);
  start.diagram = std::move(result.diagram);
  start.diagrams = result.diagrams;
}

void report_start_options(Run& run, const Settings& settings, const ConstraintOptions& constraints,
                          std::int32_t iterations) {
  Json& reported = run.report().options();
  const GeneratorOptions& asked = run.options().generators;
  reported["relax"] = iterations;
  report_constraints(reported, constraints);
  reported["target_edge"] = asked.target_edge ? Json(*asked.target_edge) : nullptr;
  reported["loose_boundary"] = settings.loose_boundary;
  run.report().results()["relaxation"] = nullptr;
}

/// Copies that generators are relaxed on, wherever these have at most half of the mesh's faces. Measured with five
/// seeds on nine models (docs/notes/performance.md).
constexpr CopySize kCopySize{1'500, 20'000, 8};

/// Smaller meshes have no copy by default where generators follow curves: with 500 generators, the least angle of the
/// fandisk was 23 degrees instead of 28. These are means of five seeds.
constexpr std::int64_t kCurvesAbove = 300'000;

/// The generators of the run, or as many as `count`, relaxed as the options say.
RelaxedStart make_start(Run& run, const CheckedMesh& input, const Settings& settings,
                        std::optional<std::int32_t> count) {
  const std::int32_t iterations = relax_iterations(settings, run.options().generators);
  ConstraintOptions constraints = settings.constraints;
  constraints.prefers_boundary = !settings.loose_boundary;
  constraints.coarse_above = 0;
  constraints.copy_size = kCopySize;
  const bool may_add = !settings.no_refine && settings.remesh.max_added != 0;
  // Most are added opposite generators that the relaxation moves to gaps. With an exact number, there are none.
  constraints.leaves_room = may_add && iterations > 0 && !settings.exact_count;
  // A remesh that may add no generators can't follow creases that need more.
  if (!may_add) constraints.auto_features = false;
  report_start_options(run, settings, constraints, iterations);
  // By default small meshes have no copy where generators on curves need the mesh.
  const bool is_small = !constraints.coarse && input.mesh.face_count() <= kCurvesAbove;
  const std::int32_t expected = count.value_or(run.options().generators.count.value_or(0));
  if (is_small && constraints.prefers_boundary && expected > 0 && has_long_boundary(input.mesh, expected)) {
    constraints.coarse = 0;
  }
  if (iterations == 0) constraints.coarse = 0;
  RelaxedStart start{start_relaxation(run, input, count, constraints), {}};
  if (is_small && follows_creases(input.mesh, start.constrained)) start.constrained.copy.reset();
  if (iterations > 0) relax(run, input.mesh, start, iterations);
  run.report().set_generators(input.mesh, start.constrained.points);
  return start;
}

RemeshOptions remesh_options(Run& run, const Mesh& mesh, const WeightedStart& start, const Settings& settings) {
  RemeshOptions options = settings.remesh;
  options.creases = trace_creases(mesh, start.creases, start.corner_distance);
  options.placement.method = placement_method(settings, run.options().generators);
  if (settings.shape) options.placement.shape = *settings.shape;
  for (std::size_t i = 0; i < start.freedom.size(); ++i) {
    if (start.freedom[i] == Freedom::fixed) options.placement.fixed.emplace_back(i);
  }
  const bool listed = run.options().generators.are_listed();
  options.refine = !settings.no_refine && !(settings.exact_count && listed);
  if (settings.exact_count && !listed) options.vertex_count = std::ssize(start.points);
  const auto is_free = [](Freedom freedom) { return freedom == Freedom::free; };
  options.kept = std::find_if(start.freedom.begin(), start.freedom.end(), is_free) - start.freedom.begin();
  options.diagram = make_diagram_options(run.options().compute);
  options.diagram.progress = run.progress();
  Json& reported = run.report().options();
  reported["place"] = name_in(kPlacements, options.placement.method);
  reported["shape"] = options.placement.method == Placement::fit ? Json(options.placement.shape) : nullptr;
  reported["allow_intersections"] = options.allow_intersections;
  reported["no_refine"] = settings.no_refine;
  reported["exact_count"] = settings.exact_count;
  return options;
}

/// Remeshes, and reports the time of each stage.
RemeshResult timed_remesh(Run& run, const Mesh& mesh, RelaxedStart&& start, RemeshOptions options) {
  StepTimes times(run);
  options.on_stage = [&times, &run](RemeshStage stage) {
    constexpr std::array<const char*, 5> kNames{"diagram", "dual", "placement", "search", "distance"};
    const char* const name = kNames[static_cast<std::size_t>(stage)];
    times.start(name);
    report_progress(run.progress(), name, 0);
  };
  options.earlier_diagrams = start.diagrams;
  if (start.diagram) return remesh(mesh, std::move(*start.diagram), options);
  return remesh(mesh, start.constrained.points, options);
}

/// Generators and what became of them.
struct Attempt {
  std::unique_ptr<Run> run;        ///< reports on this attempt alone
  std::vector<std::string> notes;  ///< on this attempt, to be printed if it is chosen
  RemeshOptions options;
  std::optional<RemeshResult> result;
  std::exception_ptr failure;  ///< where there is no result
};

/// A remesh from as many generators as `count`, or as the options say; `wanted`: its number of vertices, if it is not
/// to be that of the generators.
Attempt attempt(Run& run, const CheckedMesh& input, const Settings& settings, std::optional<std::int32_t> count,
                std::optional<std::int64_t> wanted = {}) {
  Attempt made;
  made.run = std::make_unique<Run>("", run.options(), run.console());
  if (settings.exact_count) run.console().hold();
  try {
    RelaxedStart start = make_start(*made.run, input, settings, count);
    made.options = remesh_options(*made.run, input.mesh, start.constrained, settings);
    if (wanted) made.options.vertex_count = wanted;
    made.result = timed_remesh(*made.run, input.mesh, std::move(start), made.options);
    made.options.max_added = made.result->max_added;
    made.run->report().options()["max_added"] = made.result->max_added;
  } catch (const Error& error) {
    const bool may_help = error.code() == ErrorCode::no_valid_result && made.options.vertex_count;
    if (!may_help && !(wanted && error.code() == ErrorCode::precondition)) throw;
    made.failure = std::current_exception();
  }
  made.notes = run.console().take_held();
  return made;
}

double rms(const RemeshResult& result) { return std::max(result.input_to_output.rms, result.output_to_input.rms); }

/// A remesh of exactly as many vertices, also from fewer generators where many have to make room for those added: then
/// all but the added ones are spread evenly. The nearer remesh is taken.
Attempt choose_start(Run& run, const CheckedMesh& input, const Settings& settings, Attempt first) {
  if (!first.options.vertex_count) return first;
  const std::int64_t wanted = *first.options.vertex_count;
  const double exchanged = first.result ? double(first.result->left_out) : kFewerStart * double(wanted);
  const auto fewer = static_cast<std::int32_t>(double(wanted) - exchanged);
  if (exchanged <= kFewExchanged * double(wanted) || fewer < 1) return first;
  Attempt second = attempt(run, input, settings, fewer, wanted);
  const bool is_better = second.result && (!first.result || rms(*second.result) < rms(*first.result));
  if (is_better) std::swap(first, second);
  run.report().set_time("other start", second.run->report().total_time());
  return first;
}

/// Generators and their remesh; `count` stands in for the number of the options.
RemeshResult make_remesh(Run& run, const CheckedMesh& input, const Settings& settings,
                         std::optional<std::int32_t> count) {
  const Mesh& mesh = input.mesh;
  Attempt made = choose_start(run, input, settings, attempt(run, input, settings, count));
  for (const std::string& note : made.notes) run.console().note(note);
  if (!made.result) std::rethrow_exception(made.failure);
  run.report().merge(made.run->report());
  RemeshResult& result = *made.result;
  report_remesh(run.report().results(), mesh, result);
  run.report().set_diagram(result.diagram);
  run.figures().regions = std::ssize(result.diagram.cells);
  run.report().set_generators(mesh, result.generators);
  for (const std::string& line : describe_remesh(result, made.options)) run.console().note(line);
  return std::move(result);
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
      const RemeshResult result = make_remesh(trial, input_, settings_, count);
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

/// At most four generators for each vertex of the input are tried, or 2000 where it has few.
FewestOptions search_options(const Mesh& mesh, const ErrorBound& bound) {
  FewestOptions options;
  options.target = bound.value * (bound.in_diagonals ? mesh.bbox_diagonal() : 1);
  options.most = static_cast<std::int32_t>(std::clamp<std::int64_t>(4LL * mesh.vertex_count(), 2000, 1000000000));
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

/// The number of generators for a mean length of edges: by the area that each one has in an even triangulation.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("--target-edge {}: this takes {:.3g} generators; ask for longer edges", edge, count));
}

/// Refuses a mesh without area. Single triangles without area are ordinary input.
void check_area(const Run& run, const Mesh& mesh) {
  if (compute_area(mesh) > 0) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: no triangle has an area, so there is nothing to remesh; give a surface with area",
                          run.options().input.path));
}

/// The map that `--map` and `--carry` need; empty without them.
RemeshMap make_map(Run& run, const Mesh& mesh, const RemeshResult& result, bool carry) {
  const std::string& path = run.options().output.own.at(kMap);
  run.report().options()["map"] = path.empty() ? Json() : Json(path);
  if (path.empty() && !carry) return {};
  return run.timed("map", [&] { return map_to_remesh(mesh, result, run.options().compute.threads, run.progress()); });
}

/// Writes `--map`; the report and a note tell how good the map is.
void write_map(Run& run, const CheckedMesh& input, const RemeshMap& map) {
  if (run.options().output.own.at(kMap).empty()) return;
  run.console().note(report_map(run.report().results(), map));
  write_own_file(run, kMap, [&](std::ostream& out) { write_map_json(out, input, map); });
}

/// Properties and texture of the input file, on the remesh.
struct Carried {
  std::vector<MeshProperty> properties;
  std::vector<std::array<double, 2>> texture;  ///< of the corners of faces; empty where the file has none
};

/// `standard_input`: the text that standard input held, if INPUT is `-`.
MeshAttributes read_attributes(const InputOptions& input, const std::string& standard_input) {
  if (input.path != "-") return read_mesh_attributes(input.path, input.format);
  return parse_mesh_attributes(standard_input, *input.format, kStandardInput);
}

/// Reads the properties and the texture of the input file, and carries them over. Notes where there is nothing to carry
/// over, and what no output holds.
Carried carry(Run& run, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map,
              const std::string& standard_input) {
  Carried carried = run.timed("carry", [&] {
    const MeshAttributes found = read_attributes(run.options().input, standard_input);
    Carried made{carry_properties(input, found.properties, result, map), {}};
    if (found.texture) made.texture = carry_texture(input, *found.texture, result, map);
    return made;
  });
  if (carried.properties.empty() && carried.texture.empty()) {
    note_on_input(run, "no properties and no texture coordinates to carry over");
  } else if (!carried.properties.empty() && !contains(written_formats(run.options().output), "ply")) {
    run.console().note("--carry: OBJ holds texture coordinates only; properties need -o FILE.ply");
  }
  return carried;
}

void write_remesh(Run& run, const Mesh& mesh, const RemeshResult& result, const Carried& carried) {
  LabelledMesh coarse{result.mesh};
  coarse.properties = &carried.properties;
  if (!carried.texture.empty()) coarse.corner_texture = &carried.texture;
  const auto json = [&](std::ostream& out) { write_remesh_json(out, mesh, result); };
  write_output_files(run, coarse, {{"json", json}});
}

void write_view(Run& run, const Mesh& mesh, const RemeshResult& result) {
  Mesh unplaced;  // the scenes refer to it
  write_view_file(run, "gvd-remesh", [&] {
    unplaced = make_unplaced(mesh, result);
    return make_remesh_scenes(mesh, result, unplaced, run.options().compute.threads, run.progress());
  });
}

void run_remesh(Run& run, const Settings& settings) {
  check_settings(run.options(), settings);
  run.report().options()["carry"] = settings.carry;
  std::string standard_input;
  const CheckedMesh input = load_input(run, settings.carry ? &standard_input : nullptr);
  const Mesh& mesh = input.mesh;
  check_area(run, mesh);
  const GeneratorOptions& asked = run.options().generators;
  std::optional<std::int32_t> count;
  if (asked.error) count = search_count(run, input, settings);
  if (asked.target_edge) count = count_for(mesh, *asked.target_edge);
  const RemeshResult result = make_remesh(run, input, settings, count);
  const RemeshMap map = make_map(run, mesh, result, settings.carry);
  const Carried carried = settings.carry ? carry(run, input, result, map, standard_input) : Carried();
  write_remesh(run, mesh, result, carried);
  write_diagram_file(run, mesh, result.diagram);
  write_map(run, input, map);
  write_view(run, mesh, result);
  finish_run(run, mesh, result.diagram);
}

}  // namespace
}  // namespace gvd::app

int main(int argc, char** argv) {
  using namespace gvd;
  using namespace gvd::app;
  Settings settings;
  Command command({"gvd-remesh",
                   "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point.",
                   kExamples,
                   {{"ply", "obj", "off", "stl", "vtp", "glb", "json"}, false}});  // the coarse mesh has no labels
  register_settings(command, settings);
  command.add_target(
      kMap, "FILE.json",
      "Write the point of INPUT for each output vertex, and the point of the output for each input vertex", {"json"});
  return command.run(argc, argv, [&](Run& run) { run_remesh(run, settings); });
}
