// gvd-remesh: builds the coarse mesh that is dual to a diagram.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/command.hpp"
#include "common/options/file_extension.hpp"
#include "common/options/typed_options.hpp"
#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/carry_properties.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/surface_area.hpp"
#include "remesh/make_remesh.hpp"
#include "remesh/remesh_report.hpp"
#include "remesh/remesh_scenes.hpp"

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

constexpr const char* kMap = "--map";

void register_options(app::CommandLine& line, app::Settings& settings) {
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
                  settings.place, app::placement_names());
  line.add_flag({"--allow-intersections", "",
                 "Accept triangles that intersect each other; without it, generators are added there", group},
                settings.remesh.allow_intersections);
  line.add_flag(
      {"--carry", "",
       "Give PLY output the colours and other properties of a PLY input, PLY and OBJ its texture coordinates", group},
      settings.carry);
}

bool writes(const app::OutputOptions& output, std::string_view format) {
  return std::any_of(output.files.begin(), output.files.end(), [&](const std::string& file) {
    return (file == "-" ? app::stdout_format(output) : app::file_extension(file)) == format;
  });
}

/// Refuses what contradicts the outputs or does nothing.
void check_settings(const app::Options& options, const app::Settings& settings) {
  if (options.output.no_curves) {
    throw Error(ErrorCode::invalid_option, "--no-curves: the files of gvd-remesh have no curves; leave it out");
  }
  if (settings.carry && !writes(options.output, "ply") && !writes(options.output, "obj")) {
    throw Error(ErrorCode::invalid_option,
                "--carry: only PLY and OBJ files hold what is carried over; write one, such as -o FILE.ply");
  }
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
  app::report_map(run.report().results(), map);
  run.console().note(app::describe_map(map));
  app::write_own_file(run, kMap, [&](std::ostream& out) { app::write_map_json(out, input, map); });
}

/// What the input file holds, on the remesh.
struct Carried {
  std::vector<MeshProperty> properties;
  std::vector<std::array<double, 2>> texture;  ///< of the corners of faces; empty where the file has none
};

/// `standard_input`: the text that standard input held, if INPUT is `-`.
MeshAttributes read_attributes(const app::InputOptions& input, const std::string& standard_input) {
  const auto format = format_from_extension(input.format);
  if (input.path != "-") return read_mesh_attributes(input.path, format);
  return parse_mesh_attributes(standard_input, *format, app::kStandardInput);
}

/// Reads the properties and the texture of the input file, and carries them over. Notes where there is nothing to carry
/// over, and what no output holds.
Carried carry(app::Run& run, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map,
              const std::string& standard_input) {
  const app::InputOptions& options = run.options().input;
  Carried carried = run.timed("carry", [&] {
    const MeshAttributes found = read_attributes(options, standard_input);
    Carried made{carry_properties(input, found.properties, result, map), {}};
    if (found.texture) made.texture = carry_texture(input, *found.texture, result, map);
    return made;
  });
  if (carried.properties.empty() && carried.texture.empty()) {
    run.console().note(fmt::format("{}: no properties and no texture coordinates to carry over",
                                   options.path == "-" ? app::kStandardInput : options.path));
  } else if (!carried.properties.empty() && !writes(run.options().output, "ply")) {
    run.console().note("--carry: OBJ holds texture coordinates only; properties need -o FILE.ply");
  }
  return carried;
}

void write_remesh(app::Run& run, const Mesh& mesh, const RemeshResult& result, const Carried& carried) {
  LabelledMesh coarse{result.mesh};
  coarse.properties = &carried.properties;
  if (!carried.texture.empty()) coarse.corner_texture = &carried.texture;
  const auto json = [&](std::ostream& out) { app::write_remesh_json(out, mesh, result); };
  app::write_output_files(run, coarse, {{"json", json}});
}

void write_view(app::Run& run, const Mesh& mesh, const RemeshResult& result) {
  Mesh unplaced;  // the scenes refer to it
  app::write_view_file(run, "gvd-remesh", [&] {
    unplaced = app::make_unplaced(mesh, result);
    return app::make_remesh_scenes(mesh, result, unplaced, run.options().compute.threads);
  });
}

void run_remesh(app::Run& run, const app::Settings& settings) {
  check_settings(run.options(), settings);
  run.report().options()["carry"] = settings.carry;
  app::check_relaxation(settings.relaxation, run.options().generators);
  std::string standard_input;
  const CheckedMesh input = app::load_input(run, settings.carry ? &standard_input : nullptr);
  const Mesh& mesh = input.mesh;
  check_area(run, mesh);
  const RemeshResult result = app::make_remesh(run, input, settings);
  const RemeshMap map = make_map(run, mesh, result, settings.carry);
  const Carried carried = settings.carry ? carry(run, input, result, map, standard_input) : Carried();
  write_remesh(run, mesh, result, carried);
  app::write_diagram_file(run, mesh, result.diagram);
  write_map(run, input, map);
  write_view(run, mesh, result);
  app::finish_run(run, mesh, result.diagram);
}

}  // namespace

int main(int argc, char** argv) {
  app::Settings settings;
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
