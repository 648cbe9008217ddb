// gvd-remesh: builds the coarse mesh that is dual to a diagram.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "common/options/typed_options.hpp"
#include "common/run/command.hpp"
#include "common/run/step_times.hpp"
#include "common/steps/load_input.hpp"
#include "common/steps/verify.hpp"
#include "common/steps/write_outputs.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "remesh/carry.hpp"
#include "remesh/map_json.hpp"
#include "remesh/relax_start.hpp"
#include "remesh/remesh_json.hpp"
#include "remesh/remesh_report.hpp"
#include "remesh/remesh_scenes.hpp"
#include "remesh/search_count.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-remesh bunny.obj -n 2000 -o coarse.obj\n"
    "  gvd-remesh part.stl --features 40 --error 0.5% -o coarse.obj\n"
    "  gvd-remesh bunny.obj -n 2000 --relax 40 --density curvature -o coarse.ply\n"
    "  gvd-remesh bunny.obj --generators samples.json -o coarse.ply\n"
    "  gvd-remesh bunny.obj -n 500 --view coarse.html --report report.json\n"
    "  gvd-remesh bunny.obj -n 500 --no-refine -o coarse.off\n"
    "  gvd-remesh scans/*.stl -n 500 --output-dir coarse --output-format obj\n";

constexpr app::Range<std::int64_t> kMaxAdded{0, 1000000000, "a whole number from 0 to 1000000000"};

const app::Choices<Placement> kPlacements{
    {"generator", Placement::generator}, {"quadric", Placement::quadric}, {"fit", Placement::fit}};

constexpr const char* kMap = "--map";

struct Settings {
  RemeshOptions remesh;
  app::RelaxOptions relaxation;
  std::optional<Placement> place;  ///< as given
  bool no_refine = false;
  bool carry = false;
};

/// Listed generators are where the user wants the vertices.
Placement default_placement(const app::GeneratorOptions& generators) {
  return generators.are_listed() ? Placement::generator : PlacementOptions().method;
}

void register_options(app::CommandLine& line, Settings& settings) {
  const std::string group = "Remesh";
  app::add_number(line,
                  {"--max-added",
                   "",
                   "Most generators that may be added (default: ten for each given one, component, boundary loop and "
                   "handle, and 100 more)",
                   group,
                   {},
                   {"--no-refine", "--exact-count"}},
                  settings.remesh.max_added, kMaxAdded);
  line.add_flag(
      {"--no-refine", "", "Add no generators: refuse where the given ones are too few for a valid mesh", group},
      settings.no_refine);
  line.add_flag({"--exact-count", "", "The same as --no-refine: exactly the given number of vertices, or none", group},
                settings.no_refine);
  app::add_choice(line,
                  {"--place", "",
                   "Vertices at the generators, at the best points for their cells' planes, or fitted to the surface "
                   "(default: fit, for --generators and --vertices generator)",
                   group},
                  settings.place, kPlacements);
  line.add_flag({"--allow-intersections", "",
                 "Accept triangles that intersect each other; without it, generators are added there", group},
                settings.remesh.allow_intersections);
  line.add_flag(
      {"--carry", "",
       "Give PLY output the colours and other properties of a PLY input, PLY and OBJ its texture coordinates", group},
      settings.carry);
}

/// Remeshes, and reports the time of each stage.
RemeshResult timed_remesh(app::Run& run, const Mesh& mesh, app::RelaxedStart&& start, RemeshOptions options) {
  app::StepTimes times(run);
  options.on_stage = [&times](RemeshStage stage) {
    constexpr std::array<const char*, 5> kNames{"diagram", "dual", "placement", "search", "distance"};
    times.start(kNames[static_cast<std::size_t>(stage)]);
  };
  if (start.diagram) return remesh(mesh, std::move(*start.diagram), options);
  return remesh(mesh, start.constrained.points, options);
}

/// `freedom`: what the relaxation let each generator do; empty if all moved.
PlacementOptions placement_options(app::Run& run, const std::vector<Freedom>& freedom, const Settings& settings) {
  PlacementOptions options;
  options.method = settings.place.value_or(default_placement(run.options().generators));
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    if (freedom[i] == Freedom::fixed) options.fixed.emplace_back(static_cast<std::int64_t>(i));
  }
  for (const auto& [name, value] : kPlacements) {
    if (value == options.method) run.report().options()["place"] = name;
  }
  return options;
}

RemeshResult make_remesh(app::Run& run, const Mesh& mesh, app::RelaxedStart&& start, const Settings& settings) {
  const app::ConstrainedStart& given = start.constrained;
  RemeshOptions options = settings.remesh;
  options.creases = trace_creases(mesh, given.creases, given.corner_distance);
  options.placement = placement_options(run, given.freedom, settings);
  if (!options.max_added) options.max_added = default_max_added(compute_mesh_summary(mesh), given.points.size());
  options.refine = !settings.no_refine;
  app::report_remesh_options(run, options);
  options.diagram = app::make_diagram_options(run.options().compute);
  options.diagram.progress = run.progress();
  RemeshResult result = timed_remesh(run, mesh, std::move(start), options);
  app::report_remesh(run, mesh, result, options);
  return result;
}

/// The generators and their remesh. With --error, as many generators as it takes.
RemeshResult make_result(app::Run& run, const CheckedMesh& input, Settings settings) {
  const auto remesh_with = [&](app::Run& trial, std::optional<std::int32_t> count) {
    settings.relaxation.constraints.count = count;
    return make_remesh(trial, input.mesh, app::make_relaxed_start(trial, input, settings.relaxation), settings);
  };
  if (!run.options().generators.error) return remesh_with(run, std::nullopt);
  return remesh_with(run, app::search_count(run, input.mesh, remesh_with));
}

/// Refuses a mesh without area. Single triangles without area are ordinary input.
void check_area(const app::Run& run, const Mesh& mesh) {
  if (compute_area(mesh) > 0) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: no triangle has an area, so there is nothing to remesh; give a surface with area",
                          run.options().input.path));
}

/// For `--map` and `--carry`; empty without them.
RemeshMap make_map(app::Run& run, const Mesh& mesh, const RemeshResult& result, bool carry) {
  const std::string& path = run.options().output.own.at(kMap);
  run.report().options()["map"] = path.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(path);
  if (path.empty() && !carry) return {};
  return run.timed("map", [&] { return map_to_remesh(mesh, result, run.options().compute.threads); });
}

/// Writes `--map`; the report and a note tell how good the map is.
void write_map(app::Run& run, const CheckedMesh& input, const RemeshMap& map) {
  if (run.options().output.own.at(kMap).empty()) return;
  app::report_map(run, map);
  app::write_own_file(run, kMap, [&](std::ostream& out) { app::write_map_json(out, input, map); });
}

void run_remesh(app::Run& run, const Settings& settings) {
  if (run.options().output.no_curves) {
    throw Error(ErrorCode::invalid_option, "--no-curves: the files of gvd-remesh have no curves; leave it out");
  }
  if (settings.carry) app::check_carry(run);
  run.report().options()["carry"] = settings.carry;
  app::check_relaxation(settings.relaxation, run.options().generators);
  std::string standard_input;
  const CheckedMesh input = app::load_input(run, settings.carry ? &standard_input : nullptr);
  const Mesh& mesh = input.mesh;
  check_area(run, mesh);
  const RemeshResult result = make_result(run, input, settings);
  const RemeshMap map = make_map(run, mesh, result, settings.carry);
  const auto json = [&](std::ostream& out) { app::write_remesh_json(out, mesh, result); };
  app::Carried carried;
  if (settings.carry) carried = app::carry(run, input, result, map, standard_input);
  LabelledMesh coarse{result.mesh};
  coarse.properties = &carried.properties;
  if (!carried.texture.empty()) coarse.corner_texture = &carried.texture;
  app::write_output_files(run, coarse, {{"json", json}});
  app::write_diagram_file(run, mesh, result.diagram);
  write_map(run, input, map);
  Mesh unplaced;  // the scenes refer to it
  app::write_view_file(run, "gvd-remesh", [&] {
    unplaced = app::make_unplaced(mesh, result);
    return app::make_remesh_scenes(mesh, result, unplaced, run.options().compute.threads);
  });
  app::verify(run, mesh, result.diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  app::CommandInfo info{"gvd-remesh",
                        "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point.",
                        kExamples,
                        {"ply", "obj", "off", "stl", "vtp", "glb", "json"}};
  info.sizes = true;
  info.materials = false;  // the coarse mesh has no labels
  app::Command command(info);
  app::register_relaxation(command.line(), settings.relaxation);
  register_options(command.line(), settings);
  command.add_target(
      {kMap, "FILE.json", "Write each output vertex's point of INPUT, and each input vertex's point of the output"},
      {"json"});
  return command.run(argc, argv, [&](app::Run& run) { run_remesh(run, settings); });
}
