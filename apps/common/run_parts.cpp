// The parts that the runs of the commands share: INPUT, generators, diagram, files, and the end.
//
// Each part calls a step on values within `timed`, notes its result on standard error, and fills in its members of the
// report. Users see the order of notes and times, so it stays. Output formats that can't hold the coordinates of the
// mesh are refused as soon as the mesh is known. Listed generators are where the user wants them: they are only moved
// to the surface. Sampling is seeded, so that the same options give the same points.

#include "common/run_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>
#include <utility>

#include "common/given_files.hpp"
#include "common/options/options.hpp"
#include "common/process.hpp"
#include "common/referred_files.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#ifdef GVD_HAS_VERIFY
#include "gvd/verify.hpp"
#endif

namespace gvd::app {
namespace {

std::string name_of(const InputOptions& input) { return input.path == "-" ? kStandardInput : input.path; }

/// All bytes of a pipe.
std::string read_pipe(const std::string& path) {
  if (path == "-") return read_standard_input();
  std::ifstream file(path, std::ios::binary);
  std::string bytes = read_to_end(file);
  if (!file.is_open() || file.bad()) {
    throw Error(ErrorCode::unreadable_input, path + ": can't be read to its end; check its permissions");
  }
  return bytes;
}

PolygonSoup read(const InputOptions& input, PipedInput* piped) {
  const WaitForInput wait(input.path);
  if (input.path != "-" && (piped == nullptr || !is_read_once(input.path))) return read_soup(input.path, input.format);
  std::string bytes = read_pipe(input.path);
  const auto format = input.format ? input.format : detect_format(bytes, input.path);
  if (!format) {
    throw Error(ErrorCode::unreadable_input,
                input.path + ": the content does not tell the format; name the format with " + input_format_option());
  }
  PolygonSoup soup = parse_soup(bytes, *format, name_of(input));
  if (piped != nullptr) *piped = {std::move(bytes), *format};
  return soup;
}

/// Errors name the file, as those of `build_mesh`.
void weld_input(PolygonSoup& soup, const InputOptions& input) {
  try {
    weld_soup(soup, *input.weld);
  } catch (const Error& error) {
    throw error.at(name_of(input));
  }
}

/// Refuses, before the work starts, formats that can't hold the result: it lies in the bounding box of the input.
void check_formats(const OutputOptions& output, const Mesh& mesh) {
  std::vector<std::string> formats = written_formats(output);
  for (const auto& [option, file] : output.own) formats.push_back(file_extension(*file));
  for (const std::string& name : formats) {
    if (const auto format = parse_output_format(name)) check_format(mesh, *format);
  }
}

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
}
#else
// check_options has refused --verify.
void verify(Run&, const Mesh&, const Diagram&) {}
#endif

/// The mesh as the options want it.
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

/// Writes the file of an option, which is empty where the option is not given.
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

/// Notes for each format with 32-bit floats that they damage the surface.
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

/// Where coordinates are multiples of more than this fraction of a face's mean edge, written points are that far off:
/// farther than the default chord tolerance lets bisectors be. A smaller share of the area than the second is not told.
constexpr double kCoarseGrid = 1e-4, kCoarseShare = 1e-3;

/// Notes that doubles are too coarse for the faces, which lie far from the origin.
void note_coarse_coordinates(Run& run, const Mesh& mesh) {
  double area = 0, coarse_area = 0, grid = 0, edge = 0;
  for (const FaceId f : mesh.faces()) {
    double largest = 0;
    for (const VertexId v : mesh.vertices(f)) largest = std::max(largest, mesh.position(v).cwiseAbs().maxCoeff());
    const auto& length = mesh.shape(f).length;
    const double mean = (length[0] + length[1] + length[2]) / 3, step = std::nextafter(largest, HUGE_VAL) - largest;
    area += mesh.area(f);
    if (!(step > kCoarseGrid * mean)) continue;
    if (coarse_area == 0) std::tie(grid, edge) = std::pair(step, mean);
    coarse_area += mesh.area(f);
  }
  if (!(coarse_area > kCoarseShare * area)) return;
  note_on_input(run,
                fmt::format("coordinates are multiples of {:.2g} so far from the origin, and edges there are {:.2g} "
                            "long: results are no more exact; move the model to the origin",
                            grid, edge));
}

/// The median of numbers, which are reordered; of an even number, the upper one.
double take_median(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + std::ssize(numbers) / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// A vertex so many times as far from the middle as half of all vertices is rather a slip than a part of a model: a
/// town of kilometres beside details of a metre has a thousand.
constexpr double kFarVertex = 1e4;

/// Notes vertices far outside of the others. The middle is that of the medians, which a few far ones do not move.
void note_far_vertices(Run& run, const CheckedMesh& checked) {
  const Mesh& mesh = checked.mesh;
  Vec3 middle;
  std::vector<double> numbers(std::size_t(mesh.vertex_count()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const VertexId v : mesh.vertices()) numbers[v.index()] = mesh.position(v)[axis];
    middle[axis] = take_median(numbers);
  }
  const auto distance = [&](VertexId v) { return (mesh.position(v) - middle).stableNorm(); };
  for (const VertexId v : mesh.vertices()) numbers[v.index()] = distance(v);
  const double usual = take_median(numbers);
  std::int64_t count = 0;
  VertexId farthest;
  for (const VertexId v : mesh.vertices()) {
    if (!(distance(v) > kFarVertex * usual)) continue;
    ++count;
    if (!farthest.valid() || distance(v) > distance(farthest)) farthest = v;
  }
  if (count == 0 || usual == 0) return;
  note_on_input(run, fmt::format("{} far outside: vertex {} is {:.4g} from the middle, where half of all vertices are "
                                 "within {:.4g}; check its coordinates",
                                 counted(count, "vertex lies", "vertices lie"), checked.input_vertex[farthest],
                                 distance(farthest), usual));
}

}  // namespace

void note_on_input(Run& run, const std::string& message) {
  const Options& options = run.options();
  run.note(options.output.folder.empty() ? name_of(options.input) + ": " + message : message);
}

CheckedMesh load_input(Run& run, PipedInput* piped) {
  const InputOptions& input = run.options().input;
  PolygonSoup soup = run.timed("read", [&] { return read(input, piped); });
  check_referred_files(run.options(), soup.appearance);
  if (input.weld) run.timed("weld", [&] { weld_input(soup, input); });
  CheckedMesh checked = run.timed("check", [&] { return build_mesh(soup, input.on_defect, name_of(input)); });
  for (const std::string& message : checked.defects.messages) note_on_input(run, message);
  note_coarse_coordinates(run, checked.mesh);
  note_far_vertices(run, checked);
  check_formats(run.options().output, checked.mesh);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  run.report().set_input(summary, checked.defects);
  run.console().detail(fmt::format("{}, {}, {}, {}", counted(summary.vertices, "vertex", "vertices"),
                                   counted(summary.faces, "face", "faces"),
                                   counted(summary.components, "component", "components"),
                                   counted(summary.boundary_loops, "boundary loop", "boundary loops")));
  read_given_files(run, checked);
  return checked;
}

namespace {

/// "50 s", "11 min" or "2 h", with two digits at most: estimates have no more.
std::string format_duration(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", std::round(seconds / 10) * 10);
  return seconds < 2 * kHour ? fmt::format("{:.0f} min", seconds / kMinute) : fmt::format("{:.0f} h", seconds / kHour);
}

/// Shorter runs need no warning.
constexpr double kLongRun = 10;  // seconds

}  // namespace

void note_many_generators(Run& run, const Mesh& mesh, std::int64_t count, const GeneratorCost& cost) {
  const double seconds = cost.microseconds * 1e-6 * double(count);
  if (count <= mesh.face_count() || seconds < kLongRun) return;
  run.note(fmt::format(
      "\1count={}\2 is more than the mesh has faces ({}): this may take about {} and {:.2g} GB of memory, at {:.2g} ms "
      "and {:.2g} kB a generator as measured on two cores",
      count, mesh.face_count(), format_duration(seconds), cost.kilobytes * 1e-6 * double(count),
      cost.microseconds * 1e-3, cost.kilobytes));
}

std::string property_file(Run& run) {
  const std::string& path = run.options().input.path;
  return is_read_once(path) ? "" : path;
}

void refuse_name(Run& run, const std::string& option, const std::string& name) {
  const std::string file = property_file(run);
  std::error_code ignored;
  std::string why = fmt::format("there is no such file, and {} has no such property; check the name", file);
  if (file.empty()) {
    why = fmt::format("there is no such file, and properties are read from files only: save {} as one",
                      name_of(run.options().input));
  }
  if (std::filesystem::is_directory(name, ignored)) why = "is a directory; give a file";
  if (name == "-") why = "takes a file or a property; standard input is the file /dev/stdin";
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", placeholder(option, name), why));
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
  if (output.report.empty() && output.summary.empty()) return;  // figures of a million regions take time
  run.report().results().update(nlohmann::ordered_json::parse(figures_json(object)));
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
    object.part_writers(option).at(file_extension(*run.options().output.own.at(option)))(out);
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
  run.report().set_peak_memory(peak_memory_bytes());
  const Options& options = run.options();
  run.report().options() = nlohmann::ordered_json::parse(options_json(*options.list, *options.given));
  run.report().options()["input"] = options.input.path;
  write_file(path, [&](std::ostream& out) { run.report().write(out); });
  run.add_written(path);
}

}  // namespace gvd::app
