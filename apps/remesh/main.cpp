// gvd-remesh: builds the coarse mesh that is dual to a diagram.
//
// The library makes it (gvd/remesh_surface.hpp). Here are the files that options name, the report and the notes, and
// the maps and properties that are carried over. --error asks for the fewest generators whose remesh is near enough:
// the number is searched for first, and the run follows with it.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/command.hpp"
#include "common/options/options.hpp"
#include "common/options/shared_options.hpp"
#include "common/process.hpp"
#include "common/relaxation.hpp"
#include "common/run_parts.hpp"
#include "gvd/carry_properties.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_options.hpp"
#include "gvd/remesh_scenes.hpp"
#include "gvd/remesh_surface.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#include "remesh/remesh_report.hpp"

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

/// 30,000 generators on 5,876 faces took 14 s of processor time and 0.44 GB.
constexpr GeneratorCost kGeneratorCost{460, 14.7};

const std::vector<std::string> kFormats{"ply", "obj", "off", "stl", "vtp", "vtu", "glb", "json", "surf.gii", "fs"};

struct OwnOptions : Options {
  SurfaceRemeshOptions remesh;
  ConstraintFiles files;
  bool carry = false;
  std::string map;  ///< a file; empty: none
};

void describe_sizes(OptionList& list, GeneratorOptions& generators) {
  list.group("Sizes (in place of {option:count}, {option:generators}, {option:vertices} and {option:radius})");
  list.option("target_edge", Number{&generators.target_edge, above(0)},
              {.help = "Sample as many generators as give edges of this average length",
               .unit = "mesh units",
               .shown = Shown::main});
  list.option("error", SizeOrPercent{&generators.error},
              {.help = "Use the fewest generators whose mesh stays within this distance of the input",
               .more = ", in mesh units or in percent of the bounding box's diagonal; takes up to 17 remeshes",
               .shown = Shown::main});
  for (const char* size : {"target_edge", "error"}) list.excludes(size, {"merge_coincident"});
}

/// The options that do nothing because no generator is relaxed, or no vertex fitted.
void describe_rules(OptionList& list, const OwnOptions& own) {
  const auto is_listed = [&own] { return own.generators.are_listed(); };
  for (const char* name : {"density", "fixed", "coarse"}) {
    list.rule({name, {"relax", "generators", "vertices"}, [&own, is_listed, name](const Given& given) -> std::string {
                 const bool off = std::string_view(name) == "coarse" && own.remesh.start.copy.faces.value_or(0) == 0;
                 if (off || own.remesh.relaxation.value_or(is_listed() ? 0 : kRemeshRelaxation) > 0) return "";
                 return fmt::format("{{option:{}}}: no generator is moved; {}", name,
                                    given.has("relax") ? "leave it out, or leave out {option:relax=none}"
                                                       : "ask for it with {option:relax=N}");
               }});
  }
  list.rule({"shape", {"place", "generators", "vertices"}, [&own, is_listed](const Given& given) -> std::string {
               const Placement usual = is_listed() ? Placement::generator : Placement::fit;
               if (own.remesh.placement.value_or(usual) == Placement::fit) return "";
               return fmt::format("{{option:shape}}: no vertex is fitted; {}",
                                  given.has("place") ? "leave it out, or take {option:place=fit}"
                                                     : "ask for it with {option:place=fit}");
             }});
  list.rule(format_rule(own.output, "carry", {"ply", "obj", "glb"},
                        "{option:carry}: only PLY, OBJ and GLB files hold what is carried over; write one, such as "
                        "{option:output=FILE.ply}"));
}

void describe_own(OptionList& list, OwnOptions& own) {
  describe_input(list, own.input);
  describe_generators(list, own.generators, {"target_edge", "error"});
  describe_diagram(list, own.compute);
  describe_output(list, own.output, kFormats);
  describe_diagram_output(list, own.output);
  describe_target(list, own.output, "map", own.map, {"json"},
                  {.help = "Write the point of {option:input} for each output vertex, and the point of the output for "
                           "each input vertex"});
  describe_sizes(list, own.generators);
  list.group("Relaxation");
  describe(list, own.files);
  describe(list, own.remesh);
  list.option("carry", Flag{&own.carry},
              {.help = "Carry over the colours and other properties of a PLY input to PLY output",
               .more = ", texture coordinates to PLY, OBJ and GLB output, and materials to OBJ output"});
  describe_rules(list, own);
}

void report_relaxation(Run& run, const SurfaceRemesh& made) {
  const LloydResult& relaxed = *made.relaxation;
  note_copy(run, relaxed.copy, made.start, made.relaxation_ends_on_copy);
  run.console().detail(fmt::format("generators relaxed in {}, energy {:.6g} -> {:.6g} mesh units^4",
                                   counted(std::ssize(relaxed.iterations), "iteration", "iterations"),
                                   relaxed.initial_energy, relaxed.final_energy));
  run.report().results()["relaxation"] = {
      {"iterations", relaxed.iterations.size()},   {"stop", name_in(kLloydStopNames, relaxed.stop)},
      {"initial_energy", relaxed.initial_energy},  {"final_energy", relaxed.final_energy},
      {"extremities", relaxed.extremities.size()}, {"diagrams", relaxed.diagrams},
      {"coarse", describe_copy(relaxed.copy)}};
}

/// The library's options for this run; the user's own ones become what they stand for, for the report.
SurfaceRemeshOptions make_remesh_options(Run& run, const CheckedMesh& input, OwnOptions& own) {
  SurfaceRemeshOptions options = own.remesh;
  options.start = make_start_options(run, input, own.files, own.remesh.start);
  options.remesh.diagram = run.options().compute.diagram;
  options.remesh.diagram.progress = run.progress();
  own.remesh.relaxation = options.iterations();
  own.remesh.placement = options.chosen_placement();
  StartOptions& constraints = own.remesh.start.constraints;
  if (constraints.prefers_creases && !options.may_add()) {
    constraints.prefers_creases = false;
    constraints.crease_angle.reset();
  }
  return options;
}

/// Generators and their remesh, with the time of every step.
SurfaceRemesh make_remesh(Run& run, const Mesh& mesh, SurfaceRemeshOptions options) {
  StepTimes times(run);
  options.on_step = [&](std::string_view step) {
    times.start(step);
    run.console().set_status("");
  };
  options.on_iteration = [&run](std::int64_t iterations, double energy) { show_iteration(run, iterations, energy); };
  return remesh_surface(mesh, options);
}

void report_result(Run& run, const Mesh& mesh, OwnOptions& own, const SurfaceRemesh& made) {
  const RemeshResult& result = made.result;
  report_start(run, mesh, made.start, own.remesh.start);
  run.report().results()["relaxation"] = nullptr;
  if (made.relaxation) report_relaxation(run, made);
  own.remesh.remesh.max_added = result.max_added;
  report_remesh(run.report().results(), mesh, result);
  run.report().set_diagram(result.diagram);
  run.figures().regions = std::ssize(result.diagram.cells);
  run.report().set_generators(mesh, result.generators);
  for (const std::string& line : describe_remesh(result, made.options)) run.console().note(line);
}

/// Searches for the fewest generators that keep the distance of `--error`, and reports the trials.
std::int32_t search_count(Run& run, const Mesh& mesh, const SurfaceRemeshOptions& options) {
  const ErrorBound& bound = *run.options().generators.error;
  const double distance = bound.value * (bound.in_diagonals ? mesh.bbox_diagonal() : 1);
  const auto show = [&run](const CountTrial& trial) {
    run.console().set_status(fmt::format("{} generators tried", trial.count));
    run.console().detail(std::isfinite(trial.error)
                             ? fmt::format("{} generators: distance {:.6g} mesh units", trial.count, trial.error)
                             : fmt::format("{} generators: no mesh", trial.count));
  };
  const Fewest found = run.timed("trials", [&] { return find_remesh_count(mesh, options, distance, show); });
  run.console().set_status("");
  report_trials(run.report().results(), distance, found);
  return *found.count;
}

/// The number of generators for a mean length of edges: by the area that each one has in an even triangulation.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("--target-edge {}: this takes {:.3g} generators; ask for longer edges", edge, count));
}

/// The map that `--map` and `--carry` need; empty without them.
RemeshMap make_map(Run& run, const Mesh& mesh, const RemeshResult& result, const OwnOptions& own) {
  if (own.map.empty() && !own.carry) return {};
  return run.timed("map",
                   [&] { return map_to_remesh(mesh, result, run.options().compute.diagram.threads, run.progress()); });
}

/// Writes `--map`; the report and a note tell how good the map is.
void write_map(Run& run, const OwnOptions& own, const CheckedMesh& input, const RemeshMap& map) {
  if (own.map.empty()) return;
  run.console().note(report_map(run.report().results(), map));
  write_own_file(run, "--map", [&](std::ostream& out) { write_map_json(out, input, map); });
}

/// Properties, texture coordinates and materials of the input file, on the remesh.
struct Carried {
  std::vector<MeshProperty> properties;
  Appearance appearance;  ///< empty where the file has neither
};

std::vector<MeshProperty> read_properties(const InputOptions& input, const PipedInput& piped) {
  if (piped.bytes.empty()) return read_mesh_properties(input.path, input.format);
  return parse_mesh_properties(piped.bytes, piped.format, input.path == "-" ? kStandardInput : input.path);
}

/// Reads the properties of the input file, and carries them over, with the texture coordinates and materials. Notes
/// where there is nothing to carry over, and what no output holds.
Carried carry(Run& run, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map,
              const PipedInput& piped) {
  Carried carried = run.timed("carry", [&] {
    const std::vector<MeshProperty> found = read_properties(run.options().input, piped);
    return Carried{carry_properties(input, found, result, map), carry_appearance(input, result, map)};
  });
  if (carried.properties.empty() && carried.appearance.empty()) {
    note_on_input(run, "no properties, texture coordinates or materials to carry over");
  } else if (!carried.properties.empty() && !contains(written_formats(run.options().output), "ply")) {
    run.console().note("--carry: OBJ and GLB hold texture coordinates, and no properties; these need -o FILE.ply");
  }
  return carried;
}

void write_remesh(Run& run, const Mesh& mesh, const RemeshResult& result, const Carried& carried) {
  LabelledMesh coarse{result.mesh};
  coarse.properties = &carried.properties;
  coarse.appearance = &carried.appearance;
  const auto json = [&](std::ostream& out) { write_remesh_json(out, mesh, result); };
  write_output_files(run, coarse, {{"json", json}});
}

void write_view(Run& run, const Mesh& mesh, const RemeshResult& result) {
  Mesh unplaced;  // the scenes refer to it
  write_view_file(run, "gvd-remesh", [&] {
    unplaced = make_unplaced(mesh, result);
    return make_remesh_scenes(mesh, result, unplaced, run.options().compute.diagram.threads, run.progress());
  });
}

void run_remesh(Run& run, OwnOptions& own) {
  PipedInput piped;
  const CheckedMesh input = load_input(run, own.carry ? &piped : nullptr);
  note_many_generators(run, input.mesh, kGeneratorCost);
  if (!own.carry && !input.appearance.empty() && !run.options().output.files.empty()) {
    note_on_input(run, "texture coordinates and materials are left out; --carry keeps them in .obj, .ply and .glb");
  }
  const Mesh& mesh = input.mesh;
  const GeneratorOptions& asked = run.options().generators;
  SurfaceRemeshOptions options = make_remesh_options(run, input, own);
  if (asked.error) options.start.sampling.count = search_count(run, mesh, options);
  if (asked.target_edge) options.start.sampling.count = count_for(mesh, *asked.target_edge);
  const SurfaceRemesh made = make_remesh(run, mesh, std::move(options));
  report_result(run, mesh, own, made);
  const RemeshResult& result = made.result;
  const RemeshMap map = make_map(run, mesh, result, own);
  const Carried carried = own.carry ? carry(run, input, result, map, piped) : Carried();
  write_remesh(run, mesh, result, carried);
  write_diagram_file(run, mesh, result.diagram);
  write_map(run, own, input, map);
  write_view(run, mesh, result);
  finish_run(run, mesh, result.diagram);
}

}  // namespace

Command remesh_command() {
  return make_command<OwnOptions>(
      {"gvd-remesh",
       "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point.",
       kExamples,
       {kFormats, false}},  // the coarse mesh has no labels
      {describe_own, run_remesh});
}

}  // namespace gvd::app
