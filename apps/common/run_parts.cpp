// The parts that the runs of the commands share after loading the input: generators, diagram, files, and the end.
//
// Each part calls a step within `timed`, notes its result on standard error, and fills in its members of the report.
// Users see the order of notes and times, so it must not change.

#include "common/run_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "common/load_input.hpp"
#include "common/options/options.hpp"
#include "common/process.hpp"
#include "common/referred_files.hpp"
#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/text.hpp"
#ifdef GVD_HAS_VERIFY
#include "gvd/verify.hpp"
#endif

namespace gvd::app {
namespace {

#ifdef GVD_HAS_VERIFY
void verify(Run& run, const Mesh& mesh, const Diagram& diagram) {
  VerifyOptions options;
  options.threads = run.options().compute.threads;
  options.progress = run.progress();
  const ErrorMeasure error = run.timed("verify", [&] { return verify_diagram(mesh, diagram, options); });
  run.report().set_error_measure(error);
  run.console().note(
      fmt::format("error against exact distances: E {:.6g} mesh units^2 (the difference of a bisector's two distances, "
                  "integrated along all bisectors), mean {:.6g}, largest {:.6g} mesh units",
                  error.error_integral, error.error_mean, error.error_max));
  if (error.corrected == 0) return;
  run.console().note(fmt::format(
      "{} of {} of CGAL's distances were longer than a path on the surface, whose length was taken: on thin "
      "triangles it can miss the shortest path",
      error.corrected, error.distances));
}
#else
// check_options has already refused --verify.
void verify(Run&, const Mesh&, const Diagram&) {}
#endif

/// Chooses the content of the mesh by the options.
LabelledMesh choose_content(const OutputOptions& output, LabelledMesh mesh) {
  mesh.no_bisectors = output.no_curves;
  mesh.ascii_ply = output.ascii_ply;
  mesh.region_materials = output.region_materials;
  return mesh;
}

void write_one(Run& run, const std::string& path, const LabelledMesh& mesh, const OwnWriters& own_formats) {
  const bool standard = path == "-";
  const std::string format = format_of(run.options().output, path);
  const auto own = own_formats.find(format);
  if (own != own_formats.end()) {
    if (standard) return write_standard_output(own->second);
    write_file(path, own->second, run.progress());
    return run.add_written(path);
  }
  const auto known = parse_output_format(format);
  if (!known) {
    throw Error(ErrorCode::invalid_option, placeholder("output", path) + ": this command does not write ." + format);
  }
  const LabelledMesh chosen = choose_content(run.options().output, mesh);
  const OutputWriter write = [&](std::ostream& out) { write_mesh(out, chosen, *known); };
  if (standard) return write_standard_output(write);
  const auto materials = materials_file(path);
  if (!materials) {
    write_file(path, write, run.progress());
    return run.add_written(path);
  }
  write_mesh(path, chosen, run.progress());
  run.add_written(path);
  const bool has_own_materials = chosen.face_label != nullptr && !chosen.names_materials();
  if (has_own_materials) run.add_written(materials->string());
  if (chosen.names_materials()) note_material_files(run, path, *chosen.appearance);
}

/// Writes the file of an option. Does nothing if the path is empty, because the option is not given.
void write_timed(Run& run, const std::string& step, const std::string& path, const OutputWriter& write) {
  if (path.empty()) return;
  run.timed("write " + step, [&] { write_file(path, write, run.progress()); });
  run.add_written(path);
}

/// The formats of this run's files that hold a surface, each once.
std::vector<const Format*> surface_formats(const OutputOptions& output) {
  std::vector<const Format*> found;
  for (const std::string& file : output.files) {
    const Format* const format = find_output(format_of(output, file));
    const bool has_surface = format != nullptr && has_any(format->carries, Content::surface);
    if (has_surface && std::ranges::find(found, format) == found.end()) found.push_back(format);
  }
  return found;
}

/// Notes in one line which parts of the input's appearance the files of this run will not hold.
void note_left_out(Run& run, const Appearance& appearance) {
  const std::vector<const Format*> formats = surface_formats(run.options().output);
  std::vector<std::string> lost;
  const auto add = [&](Content content) {
    std::vector<std::string> without;
    for (const Format* const format : formats) {
      if (!has_any(format->carries, content)) without.push_back(format->extensions.front());
    }
    if (without.empty()) return;
    lost.push_back(fmt::format("{} in {}", name_in(kContentNames, content), list_extensions(without, "and")));
  };
  if (!appearance.texture.empty()) add(Content::texture);
  if (!appearance.material.empty()) add(Content::materials);
  if (!formats.empty()) lost.insert(lost.end(), appearance.unread.begin(), appearance.unread.end());
  if (!lost.empty()) note_on_input(run, fmt::format("left out: {}", fmt::join(lost, "; ")));
}

/// Notes for each format with 32-bit floats if they would damage the surface.
void note_position_loss(Run& run, const Mesh& mesh) {
  for (const Format* const format : surface_formats(run.options().output)) {
    const PositionLoss loss = measure_position_loss(mesh, format->id);
    if (!loss.is_notable) continue;
    std::string collapsed;
    if (loss.collapsed_faces > 0) {
      collapsed = fmt::format(", and {}", counted(loss.collapsed_faces, "face collapses", "faces collapse"));
    }
    const bool keeps_place = has_any(format->carries, Content::place);
    const std::string of_place = list_extensions(output_extensions(Content::place), "and") + " the place";
    run.console().note(fmt::format(".{} has 32-bit floats, which move vertices by up to {:.2g}{}; {} keep doubles{}",
                                   format->extensions.front(), loss.farthest_move, collapsed,
                                   list_extensions(output_extensions(Content::doubles), "and"),
                                   keeps_place ? "" : ", " + of_place));
  }
}

/// Formats a duration as "50 s", "11 min" or "2 h", with at most two digits, which suffice for an estimate.
std::string format_duration(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", std::round(seconds / 10) * 10);
  return seconds < 2 * kHour ? fmt::format("{:.0f} min", seconds / kMinute) : fmt::format("{:.0f} h", seconds / kHour);
}

/// Shorter runs get no warning.
constexpr double kLongRun = 10;  // seconds

}  // namespace

void note_many_generators(Run& run, const Mesh& mesh, std::int64_t count, const GeneratorCost& cost) {
  const double seconds = cost.microseconds * 1e-6 * double(count);
  if (count <= mesh.face_count() || seconds < kLongRun) return;
  run.note(fmt::format(
      "\1count={}\2 exceeds the number of faces ({}): this may take about {} and {:.2g} GB of memory, at {:.2g} ms "
      "and {:.2g} kB a generator as measured on two cores",
      count, mesh.face_count(), format_duration(seconds), cost.kilobytes * 1e-6 * double(count),
      cost.microseconds * 1e-3, cost.kilobytes));
}

void report_generators(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& points,
                       const std::vector<std::optional<double>>& snap_distance) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    run.report().generators().push_back(
        {points[i], position(mesh, points[i]), i < snap_distance.size() ? snap_distance[i] : std::nullopt});
  }
}

void report_figures(Run& run, const Object& object) {
  const OutputOptions& output = run.options().output;
  if (output.report.empty() && output.summary.empty()) return;  // the figures of a million regions take time
  run.report().at("results").update(nlohmann::ordered_json::parse(figures_json(object)));
}

void write_output_files(Run& run, const LabelledMesh& mesh, const OwnWriters& own_formats) {
  const OutputOptions& output = run.options().output;
  if (!names_file(output)) {
    run.note(fmt::format("no file was written; name one with \1output\2, \1report\2{} or \1view\2",
                         run.options().has_diagram ? ", \1diagram\2" : ""));
  }
  if (output.files.empty()) return;
  if (mesh.appearance != nullptr) note_left_out(run, *mesh.appearance);
  note_position_loss(run, mesh.mesh);
  run.timed("write", [&] {
    for (const std::string& file : output.files) write_one(run, file, mesh, own_formats);
  });
}

void write_output_files(Run& run, const Object& object) {
  write_output_files(run, object.labelled().value(), object.own_writers());
}

void write_diagram_file(Run& run, const Mesh& mesh, const Diagram& diagram) {
  write_timed(run, "diagram", run.options().output.diagram,
              [&](std::ostream& out) { write_diagram_json(out, mesh, diagram); });
}

void write_own_file(Run& run, const std::string& option, const OutputWriter& write) {
  const auto& own = run.options().output.own;
  const auto target = own.find(option);
  std::string step = option;
  std::replace(step.begin(), step.end(), '_', '-');
  if (target != own.end()) write_timed(run, step, *target->second, write);
}

void write_part_file(Run& run, const std::string& option, const Object& object) {
  write_own_file(run, option, [&](std::ostream& out) {
    const auto writers = object.part_writers(option);
    const auto found = writers.find(file_extension(*run.options().output.own.at(option)));
    // Only a part with a single format may go to a pipe without an extension (describe_target).
    (found == writers.end() ? writers.begin() : found)->second(out);
  });
}

void write_view_file(Run& run, const std::string& title, const std::function<std::vector<ViewScene>()>& make_scenes) {
  const std::string &path = run.options().output.view, &input = run.options().input.path;
  if (path.empty()) return;
  ViewOptions options;
  options.progress = run.progress();
  options.up = run.options().output.up.value_or(options.up);
  options.title = input == "-" ? title : title + ": " + std::filesystem::path(input).filename().string();
  run.timed("write view", [&] {
    const std::string page = make_view_page(make_scenes(), options);
    write_file(
        path, [&](std::ostream& out) { out << page; }, run.progress());
  });
  run.add_written(path);
}

void finish_run(Run& run, const Mesh& mesh, const Diagram& diagram) {
  if (run.options().compute.verify) verify(run, mesh, diagram);
  write_report(run);
}

void write_report(Run& run) {
  const std::string& path = run.options().output.report;
  if (path.empty()) return;
  check_interrupt();
  run.report().at("peak_memory_bytes") = peak_memory_bytes();
  const Options& options = run.options();
  nlohmann::ordered_json& told = run.report().at("options");
  told = nlohmann::ordered_json::parse(options_json(*options.list, *options.given));
  told["input"] = options.input.path;
  write_file(path, [&](std::ostream& out) { run.report().write(out); });
  run.add_written(path);
}

}  // namespace gvd::app
