// The operations for programs: meshes from arrays and files, numbers of files, curves, and the check of a diagram.
//
// Arrays pass the same checks as files: they become a polygon soup, which build_mesh examines. So does a saved mesh,
// which has no defects any more; then its elements get back the places that they had in the input.
#include "gvd/program_operations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "figures.hpp"
#include "given_arrays.hpp"
#include "gvd/check.hpp"
#include "gvd/drop_small_components.hpp"
#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/read_values.hpp"
#include "gvd/soup.hpp"

namespace gvd {
namespace {

/// Makes a soup of arrays of positions and corners.
PolygonSoup soup_of(std::span<const ArrayView> arrays) {
  if (arrays.size() < 2) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("a mesh needs two arrays, positions and faces, or a file; {} given", arrays.size()));
  }
  const std::vector<double> at = read_array(arrays[0], 0), numbers = read_array(arrays[1], 1);
  const auto columns = [&](std::size_t i) { return arrays[i].dimensions == 2 ? arrays[i].shape[1] : 1; };
  if (columns(0) != 3 || columns(1) < 3) {
    throw Error(ErrorCode::invalid_option, "positions have three columns, and faces have three or more");
  }
  std::vector<std::int64_t> corners;
  corners.reserve(numbers.size());
  for (const double corner : numbers) {
    const bool is_index = corner == std::floor(corner) && std::abs(corner) <= 0x1p53;
    if (!is_index) throw Error(ErrorCode::invalid_option, fmt::format("a face has the vertex {}", corner));
    corners.push_back(static_cast<std::int64_t>(corner));
  }
  return make_soup(at, corners, std::size_t(columns(1)));
}

/// Reads `count` whole numbers from -1 up to below `end`, and passes each to `make`.
template <class T, class Make>
std::vector<T> places(const ArrayView& view, std::size_t place, std::int64_t count, double end, const Make& make) {
  const std::vector<double> numbers = read_array(view, place);
  const bool is_right = std::ssize(numbers) == count && std::ranges::all_of(numbers, [end](double number) {
                          return number >= -1 && number < end && number == std::floor(number);
                        });
  if (!is_right) throw Error(ErrorCode::precondition, fmt::format("array {} does not belong to a saved mesh", place));
  std::vector<T> made;
  for (const double number : numbers) made.push_back(make(static_cast<std::int32_t>(number)));
  return made;
}

void describe_file(OptionList& list, GivenFile& given, Spec spec) {
  list.group("Input");
  list.option("file", File{&given.file}, std::move(spec));
  list.option("content", Flag{&given.content},
              {.help = "The last array has the bytes of the file; its name is for messages, and for its format"});
  list.needs("content", "file");
}

}  // namespace

std::string_view GivenFile::bytes() const {
  if (arrays.empty())
    throw Error(ErrorCode::invalid_option, "give the bytes of the file as an array, as \1content\2 says");
  return bytes_of(arrays.back(), arrays.size() - 1);
}

void describe(OptionList& list, MeshCall& call) {
  describe_file(list, call, {.help = "File of the mesh; without it, two arrays are the mesh"});
  list.option("input_format", choice(call.format, input_format_names()),
              {.help = "Format of the file, otherwise detected from content and extension"});
  list.option("on_defect", choice(call.on_defect, kDefectPolicyNames),
              {.help = "How to treat defects of the mesh",
               .more = ": refuse them, repair them without loss, or repair them and keep only the largest component"});
  list.option("weld", Number{&call.weld, {.least = 0}},
              {.help = "Join vertices at most this far apart; 0: those at the same place", .unit = "mesh units"});
  list.option("drop_smaller_than", SizeOrPercent{&call.drop_smaller_than},
              {.help = "Leave out components whose bounding box has a smaller diagonal than this",
               .more = ", in mesh units or in percent of the whole mesh's diagonal"});
  list.needs("input_format", "file");
}

std::shared_ptr<const MeshObject> run(MeshCall& call, Observer& observer) {
  PolygonSoup soup = as_step(observer, "read", [&] {
    if (call.content) return parse_soup(call.bytes(), call.format, call.file);
    return call.file.empty() ? soup_of(call.arrays) : read_soup(call.file, call.format);
  });
  const Step step(observer, "check");
  if (call.weld) weld_soup(soup, *call.weld);
  CheckedMesh checked = build_mesh(soup, call.on_defect, call.file);
  if (call.drop_smaller_than) drop_small_components(checked, *call.drop_smaller_than);
  return std::make_shared<MeshObject>(std::make_shared<CheckedMesh>(std::move(checked)));
}

void describe(OptionList& list, SavedMeshCall& call) {
  list.group("Input");
  list.option("repairs", File{&call.repairs}, {.help = "What was repaired"});
  list.option("materials", File{&call.materials}, {.help = "Names of materials"});
  list.option("material_files", File{&call.material_files}, {.help = "Files with the materials"});
}

std::shared_ptr<const MeshObject> run(SavedMeshCall& call, Observer&) {
  constexpr std::size_t kArrays = 7;
  if (call.arrays.size() != kArrays) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("a saved mesh has {} arrays; {} given", kArrays, call.arrays.size()));
  }
  auto made = std::make_shared<CheckedMesh>(build_mesh(soup_of(call.arrays)));
  const double vertices = made->mesh.vertex_count(), most = std::numeric_limits<std::int32_t>::max();
  const auto index = [](std::int32_t number) { return number; };
  made->mesh_vertex = places<VertexId>(call.arrays[2], 2, call.arrays[2].shape[0], vertices,
                                       [](std::int32_t number) { return number < 0 ? VertexId() : VertexId(number); });
  made->input_vertex = IdVector<VertexId, std::int32_t>(
      places<std::int32_t>(call.arrays[3], 3, made->mesh.vertex_count(), double(made->mesh_vertex.size()), index));
  made->input_polygon =
      IdVector<FaceId, std::int32_t>(places<std::int32_t>(call.arrays[4], 4, made->mesh.face_count(), most, index));
  made->defects.messages = call.repairs;
  Appearance& look = made->appearance;
  look.materials = call.materials;
  look.material_files = call.material_files;
  const std::vector<double> uv = read_array(call.arrays[5], 5);
  if (!uv.empty() && std::ssize(uv) != 6 * std::int64_t(made->mesh.face_count())) {
    throw Error(ErrorCode::precondition, "array 5 does not belong to a saved mesh");
  }
  for (std::size_t i = 0; i < uv.size(); i += 2) look.texture.push_back({uv[i], uv[i + 1]});
  const bool has_materials = call.arrays[6].shape[0] > 0;
  look.material = places<std::int32_t>(call.arrays[6], 6, has_materials ? made->mesh.face_count() : 0,
                                       double(look.materials.size()), index);
  return std::make_shared<MeshObject>(std::move(made));
}

void describe(OptionList& list, ValuesCall& call) {
  describe_file(list, call, {.help = "File to read", .required = true});
}

void NumbersObject::visit(ObjectVisitor& visitor) const {
  visitor.figure({"names", "", "of the arrays"}, each_of(numbers, &std::pair<std::string, std::vector<double>>::first));
  for (const auto& [name, values] : numbers) visitor.array({name, "", "numbers of a file"}, view(values));
}

std::shared_ptr<const NumbersObject> run(ValuesCall& call, Observer&) {
  auto made = std::make_shared<NumbersObject>();
  made->numbers.emplace_back("values", call.content ? parse_values(call.bytes(), call.file) : read_values(call.file));
  return made;
}

std::shared_ptr<const NumbersObject> run(PropertiesCall& call, Observer&) {
  auto made = std::make_shared<NumbersObject>();
  std::vector<MeshProperty> properties;
  if (!call.content) {
    properties = read_mesh_properties(call.file);
  } else if (const auto format = detect_format(call.bytes(), call.file)) {
    properties = parse_mesh_properties(call.bytes(), *format, call.file);
  }
  for (MeshProperty& property : properties) {
    if (property.count_type) continue;  // properties that are lists are left out
    made->numbers.emplace_back((property.of_vertices ? "vertex " : "face ") + property.name,
                               std::move(property.values));
  }
  return made;
}

void describe(OptionList& list, CurvesCall& call) {
  list.group("Curves");
  describe_curves(list, call.generators);
  list.option("max_snap", Number{&call.generators.max_snap, {.least = 0}},
              {.help = "Refuse a point that is farther than this from the surface", .unit = "mesh units"});
  list.one_of({{"curves"}, "no curves"});
}

void CurvesOutcome::visit(ObjectVisitor& visitor) const {
  visitor.figure({"count", "", "number of curves"}, count);
  visitor.array({"positions", "mesh units", "of the points of all polylines"}, view(positions));
  visitor.array({"offsets", "", "index of each polyline's first point, and the total number of points"}, view(offsets));
  visitor.array({"curve", "", "curve of each polyline"}, view(curve));
}

std::shared_ptr<const CurvesOutcome> run(const MeshPtr& input, CurvesCall& call, Observer& observer) {
  auto made = std::make_shared<CurvesOutcome>();
  made->offsets = {0};
  for (const GeneratorCurve& curve : choose_curves(*input, call.generators, observer)) {
    for (const std::vector<Vec3>& line : polylines(input->mesh, curve)) {
      made->positions.insert(made->positions.end(), line.begin(), line.end());
      made->offsets.push_back(std::ssize(made->positions));
      made->curve.push_back(made->count);
    }
    ++made->count;
  }
  return made;
}

std::shared_ptr<const CheckOutcome> run(const DiagramObject& on, CheckCall&, Observer& observer) {
  const Step step(observer, "check");
  auto made = std::make_shared<CheckOutcome>();
  made->violations = check_diagram(on.surface(), *on.of_surface()).violations;
  return made;
}

}  // namespace gvd
