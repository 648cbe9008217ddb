// Loads INPUT: its mesh with notes on it, and the files that options name. Each kind of option is read in one place,
// whatever the option is called. Output formats that can't hold the coordinates of the mesh are refused as soon as the
// mesh is known.

#include "common/load_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "common/process.hpp"
#include "common/referred_files.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/drop_small_components.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/option_text.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

// ---- the mesh

std::string name_of(const InputOptions& input) { return input.path == "-" ? kStandardInput : input.path; }

/// Reads all bytes of a pipe.
std::string read_pipe(const std::string& path) {
  if (path == "-") return read_standard_input();
  std::ifstream file(path, std::ios::binary);
  std::string bytes = read_to_end(file);
  if (!file.is_open() || file.bad()) {
    throw Error(ErrorCode::unreadable_input, path + ": can't be read to its end; check its permissions");
  }
  return bytes;
}

PolygonSoup read_mesh(const InputOptions& input, PipedInput* piped) {
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

/// Welds the soup. Errors name the file, as in `build_mesh`.
void weld_input(PolygonSoup& soup, const InputOptions& input) {
  try {
    weld_soup(soup, *input.weld);
  } catch (const Error& error) {
    throw error.at(name_of(input));
  }
}

/// Refuses, before the work starts, formats that can't hold the result, which lies in the bounding box of the input.
void check_formats(const OutputOptions& output, const Mesh& mesh) {
  std::vector<std::string> formats = written_formats(output);
  for (const auto& [option, file] : output.own) formats.push_back(file_extension(*file));
  for (const std::string& name : formats) {
    if (const auto format = parse_output_format(name)) check_format(mesh, *format);
  }
}

/// Doubles are too coarse for a face if neighbouring ones differ by more than kCoarseGrid of its mean edge, because
/// written points are then off by more than the default chord tolerance of bisectors. There is no note if such faces
/// have less than kCoarseShare of the area.
constexpr double kCoarseGrid = 1e-4, kCoarseShare = 1e-3;

/// Notes that doubles are too coarse for faces far from the origin.
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
                            "long: results are no more accurate than that; move the model to the origin",
                            grid, edge));
}

/// The median of numbers, which are reordered; the upper one if their count is even.
double take_median(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + std::ssize(numbers) / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// A vertex this many times as far from the middle as half of all vertices is more likely a slip than part of the
/// model. Even a town of several kilometres with details of a metre has only a factor of a thousand.
constexpr double kFarVertex = 1e4;

/// Notes vertices far outside the others. The middle is the point of the medians, which a few far vertices do not move.
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

// ---- the files that options name

/// The file from which properties of INPUT are read; empty for standard input and pipes, which can be read only once.
std::string property_file(Run& run) {
  const std::string& path = run.options().input.path;
  return is_read_once(path) ? "" : path;
}

/// Refuses the value of `option`, which names neither a file nor a property of INPUT.
[[noreturn]] void refuse_name(Run& run, const std::string& option, const std::string& name) {
  const std::string file = property_file(run);
  std::error_code ignored;
  std::string why = fmt::format("there is no such file, and {} has no such property; check the name", file);
  if (file.empty()) {
    why = fmt::format("there is no such file, and properties are read from files only: save {} as one",
                      name_of(run.options().input));
  }
  if (std::filesystem::is_directory(name, ignored)) why = "is a directory; give a file";
  if (name == "-") why = "takes a file or a property; for standard input, give /dev/stdin";
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", placeholder(option, name), why));
}

[[noreturn]] void refuse_unreadable(const std::string& message) { throw Error(ErrorCode::unreadable_input, message); }

bool is_there(const std::string& file) {
  std::error_code ignored;
  return file == "-" || std::filesystem::exists(file, ignored);
}

/// Reads a list of generators. `format`: the format, if extension and content should not decide.
GeneratorList read_list(const std::string& file, const std::optional<GeneratorFormat>& format) {
  if (file != "-") {
    const WaitForInput wait(file);
    return read_generators(file, format);
  }
  const std::string content = read_standard_input();
  return parse_generators(content, format.value_or(detect_generator_format(content)), kStandardInput);
}

/// Reads the list of points that an option names. A name that is no file may have been meant for vertices.
void read(const std::string& option, const PointList& points, const std::optional<GeneratorFormat>& format) {
  GivenPoints& given = *points.value;
  if (given.file.empty()) return;
  if (points.named == PointList::Named::any && !is_there(given.file)) {
    refuse_unreadable(fmt::format("{}: there is no such file; name one that lists points, or write vertices, as in {}",
                                  placeholder(option, user_text(given.file)), placeholder(option, "3,17,99")));
  }
  given.list = std::make_shared<GeneratorList>(read_list(given.file, format));
}

void read(const std::string& option, const Curves& curves) {
  const std::string& name = curves.value->name;
  if (name.empty() || name == "boundary" || parse_creases(name, curves.usual)) return;
  if (!is_there(name)) {
    refuse_unreadable(placeholder(option, name) +
                      ": there is no such file; write boundary, creases or the name of a file");
  }
  const WaitForInput wait(name);
  curves.value->list = std::make_shared<CurveList>(name == "-" ? parse_curves(read_standard_input(), kStandardInput)
                                                               : gvd::read_curves(name));
}

void read(Run& run, const CheckedMesh& input, const std::string& option, const ValueSource& source) {
  const std::string& name = source.value->name;
  if (name.empty() || contains(source.words, name)) return;
  const WaitForInput wait(name);  // it may be a pipe
  if (source.of == ValueSource::Of::generators) {
    const bool is_piped = name == "-";
    source.value->values = std::make_shared<ElementValues>(
        ElementValues{is_piped ? kStandardInput : name, {true, read_values(is_piped ? "/dev/stdin" : name)}});
    return;
  }
  const bool is_of_faces = source.of == ValueSource::Of::faces;
  auto found =
      read_element_values(input, name, property_file(run), is_of_faces ? SoupElement::polygon : SoupElement::vertex,
                          is_of_faces ? ValueColumns::last : ValueColumns::one);
  if (!found) refuse_name(run, option, name);
  if (is_of_faces) found->title = placeholder(option, name);
  source.value->values = std::make_shared<ElementValues>(*std::move(found));
}

/// Reads the points, curves and numbers that options name, from files or from properties of INPUT, so that operations
/// find values.
void read_given_files(Run& run, const CheckedMesh& input) {
  const Options& options = run.options();
  for (const Option* const option : options.list->options()) {
    const std::string& name = option->name;
    const auto format = option->name == "generators" ? options.input.list_format : std::nullopt;
    std::visit(Overload{[&](const PointList& points) { read(name, points, format); },
                        [&](const Curves& curves) { read(name, curves); },
                        [&](const ValueSource& source) { read(run, input, name, source); }, [](const auto&) {}},
               option->field);
  }
}

}  // namespace

void note_on_input(Run& run, const std::string& message) {
  const Options& options = run.options();
  run.note(options.output.folder.empty() ? name_of(options.input) + ": " + message : message);
}

MeshPtr load_input(Run& run, PipedInput* piped) {
  const InputOptions& input = run.options().input;
  PolygonSoup soup = run.timed("read", [&] { return read_mesh(input, piped); });
  check_referred_files(run.options(), soup.appearance);
  if (input.weld) run.timed("weld", [&] { weld_input(soup, input); });
  CheckedMesh checked = run.timed("check", [&] {
    CheckedMesh whole = build_mesh(soup, input.on_defect, name_of(input));
    if (input.drop_smaller_than) drop_small_components(whole, *input.drop_smaller_than);
    return whole;
  });
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
  return std::make_shared<CheckedMesh>(std::move(checked));
}

}  // namespace gvd::app
