// Values of options that come as arrays beside JSON.
//
// Any type of numbers serves for anything: languages differ in what they make of a list of numbers. Shapes tell what is
// meant. Entries become those of files, which resolve_generators and resolve_curves check as they check files.

#include "given_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_array(const std::string& text) { throw Error(ErrorCode::invalid_option, text); }

template <class To, class T>
To load(const std::byte* place) {
  T value;
  std::memcpy(&value, place, sizeof value);
  return static_cast<To>(value);
}

/// Of each ArrayType, in their order.
template <class To>
constexpr std::array<To (*)(const std::byte*), 10> kLoad{
    load<To, std::int8_t>,  load<To, std::uint8_t>,  load<To, std::int16_t>, load<To, std::uint16_t>,
    load<To, std::int32_t>, load<To, std::uint32_t>, load<To, std::int64_t>, load<To, std::uint64_t>,
    load<To, float>,        load<To, double>};
static_assert(std::size_t(ArrayType::float64) + 1 == kLoad<double>.size());

/// An array that may be read: its type and shape are right.
const ArrayView& checked(const ArrayView& view, std::size_t place) {
  const auto type = static_cast<std::int32_t>(view.type);
  if (type < 0 || std::size_t(type) >= kLoad<double>.size())
    refuse_array(fmt::format("array {} has no known type: {}", place, type));
  if (view.dimensions < 1 || view.dimensions > 2) {
    refuse_array(fmt::format("array {} has {} dimensions; give 1 or 2", place, view.dimensions));
  }
  if (view.shape[0] < 0 || (view.dimensions == 2 && view.shape[1] < 0)) {
    refuse_array(fmt::format("array {} has a negative length", place));
  }
  if (std::max(view.shape[0], view.dimensions == 2 ? view.shape[1] : 0) > std::numeric_limits<std::int32_t>::max()) {
    refuse_array(fmt::format("array {} has more elements than a mesh can have", place));
  }
  if (view.data == nullptr && view.shape[0] > 0) refuse_array(fmt::format("array {} is NULL", place));
  return view;
}

template <class To = double>
To number_at(const ArrayView& view, std::int64_t row, std::int64_t column) {
  const auto* const first = static_cast<const std::byte*>(view.data);
  const std::int64_t offset = row * view.strides[0] + (view.dimensions == 2 ? column * view.strides[1] : 0);
  return kLoad<To>[std::size_t(view.type)](first + offset);
}

/// `value`: an object whose only member is the place of an array.
const ArrayView& find_array(const Json& value, const Arrays& arrays) {
  const Json& place = value.front();
  const std::int64_t count = std::ssize(arrays.views);
  if (!place.is_number_integer() || place.get<std::int64_t>() < 0 || place.get<std::int64_t>() >= count) {
    refuse_array(fmt::format("there is no array {}; {} given", place.dump(), counted(count, "array is", "arrays are")));
  }
  return checked(arrays.views[place.get<std::size_t>()], place.get<std::size_t>());
}

std::int64_t columns_of(const ArrayView& view) { return view.dimensions == 2 ? view.shape[1] : 1; }

template <class Value>
[[noreturn]] void refuse_index(const Value& value, std::int64_t row) {
  throw Error(ErrorCode::invalid_option, fmt::format("element {} is {}; give whole numbers from 0 on", row, value),
              row);
}

std::int64_t to_index(double value, std::int64_t row) {
  if (value >= 0 && value == std::floor(value) && value < kMostWhole) return static_cast<std::int64_t>(value);
  refuse_index(value, row);
}

std::int64_t index_at(const ArrayView& view, std::int64_t row) {
  if (view.type == ArrayType::float32 || view.type == ArrayType::float64) return to_index(number_at(view, row, 0), row);
  const auto whole = number_at<std::int64_t>(view, row, 0);
  if (whole < 0) refuse_index(number_at(view, row, 0), row);
  return whole;
}

/// A point of a vertex alone, of a position, or of a face and barycentric coordinates.
template <class Index, class Number>
GeneratorEntry make_entry(std::int64_t columns, const Index& index, const Number& at) {
  if (columns == 1) return {GeneratorEntry::Kind::vertex, index(), {}, 0};
  if (columns == 3) return {GeneratorEntry::Kind::position, 0, {at(0), at(1), at(2)}, 0};
  return {GeneratorEntry::Kind::face, index(), {at(1), at(2), at(3)}, 0};
}

void check_columns(std::int64_t columns) {
  if (columns == 1 || columns == 3 || columns == 4) return;
  refuse_array(fmt::format(
      "points have {} columns; give vertices, positions in 3 columns, or faces and barycentric coordinates in 4",
      columns));
}

GeneratorList to_list(const ArrayView& view, const std::string& name) {
  check_columns(columns_of(view));
  GeneratorList list{name, {}};
  for (std::int64_t row = 0; row < view.shape[0]; ++row) {
    list.entries.push_back(make_entry(
        columns_of(view), [&] { return index_at(view, row); },
        [&](std::int64_t column) { return number_at(view, row, column); }));
  }
  if (list.entries.empty()) refuse_array("there is no point");
  return list;
}

/// Vertices of the mesh, under the numbers that they have in the input. Copies that repairs made have none there, and
/// are corners of faces.
GeneratorList to_list_of_mesh(const ArrayView& view, const CheckedMesh& input, const std::string& name) {
  GeneratorList list{name, {}};
  const std::int32_t count = input.mesh.vertex_count();
  for (std::int64_t row = 0; row < view.shape[0]; ++row) {
    const std::int64_t index = index_at(view, row);
    if (index >= count) {
      throw Error(ErrorCode::precondition,
                  fmt::format("there is no vertex {}; the mesh has {}, numbered from 0", index, count), row);
    }
    const VertexId v(static_cast<std::int32_t>(index));
    const std::int32_t known = input.input_vertex[v];
    if (known >= 0 && input.mesh_vertex[std::size_t(known)] == v) {
      list.entries.push_back({GeneratorEntry::Kind::vertex, known, {}, 0});
    } else {
      const SurfacePoint corner = vertex_point(input.mesh, v);
      list.entries.push_back({GeneratorEntry::Kind::face, corner.face.value(), corner.bary, 0});
    }
  }
  if (list.entries.empty()) refuse_array("there is no point");
  return list;
}

/// Numbers of JSON, which may be strings: it has no infinity.
double to_number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  const auto parsed = value.is_string() ? parse_number<double>(value.get_ref<const std::string&>()) : std::nullopt;
  if (!parsed) refuse_array(fmt::format("{} is no number", gvd::quoted(value.dump())));
  return *parsed;
}

std::int64_t to_index(const Json& value, std::int64_t row) {
  if (!value.is_number_integer()) return to_index(to_number(value), row);
  const auto whole = value.get<std::int64_t>();
  if (whole < 0) refuse_index(value.dump(), row);
  return whole;
}

/// Rows of JSON: all of positions, or all of faces and barycentric coordinates.
GeneratorList to_list(const Json& rows, const std::string& name) {
  GeneratorList list{name, {}};
  const auto columns = std::ssize(rows.front());
  check_columns(columns);
  for (const Json& row : rows) {
    if (!row.is_array() || std::ssize(row) != columns) {
      refuse_array(fmt::format("{} is no row of {} numbers, as the first point is", gvd::quoted(row.dump()), columns));
    }
    list.entries.push_back(make_entry(
        columns, [&] { return to_index(row.front(), std::ssize(list.entries)); },
        [&](std::int64_t column) { return to_number(row.at(std::size_t(column))); }));
  }
  return list;
}

/// Points as JSON files have them, such as {"vertex": 3}.
GeneratorList parse_objects(const Json& value, const std::string& name) {
  const auto odd = std::ranges::find_if(value, [](const Json& one) { return !one.is_object(); });
  if (odd != value.end()) {
    refuse_array(
        fmt::format("{} is no object, as the first point is; write {{\"vertex\": 3}} or {{\"position\": [x, y, z]}}",
                    gvd::quoted(odd->dump())));
  }
  try {
    GeneratorList list = parse_generators(Json{{"generators", value}}.dump(), GeneratorFormat::json, name);
    for (GeneratorEntry& entry : list.entries) entry.line = 0;  // there is no file
    return list;
  } catch (const Error& error) {
    throw Error(ErrorCode::invalid_option, error.text(), error.element());
  }
}

[[noreturn]] void refuse_list(const Json& value) {
  refuse_array(fmt::format("{} is no list of numbers; give one, or {{\"array\": 0}}", gvd::quoted(value.dump())));
}

/// An array of one column.
const ArrayView& find_column(const Json& value, const Arrays& arrays) {
  const ArrayView& view = find_array(value, arrays);
  if (columns_of(view) == 1) return view;
  refuse_array(fmt::format("the array has {} columns; give one number each", columns_of(view)));
}

std::vector<double> to_numbers(const Json& value, const Arrays& arrays) {
  std::vector<double> numbers;
  if (is_array_reference(value)) {
    const ArrayView& view = find_column(value, arrays);
    for (std::int64_t row = 0; row < view.shape[0]; ++row) numbers.push_back(number_at(view, row, 0));
    return numbers;
  }
  if (!value.is_array()) refuse_list(value);
  for (const Json& one : value) numbers.push_back(to_number(one));
  return numbers;
}

}  // namespace

bool is_mesh_reference(const Json& value) {
  return value.is_object() && value.size() == 1 && value.contains("mesh_vertices");
}

bool is_array_reference(const Json& value) { return value.is_object() && value.size() == 1 && value.contains("array"); }

std::vector<double> read_array(const ArrayView& view, std::size_t place) {
  const std::int64_t columns = columns_of(checked(view, place));
  std::vector<double> numbers;
  numbers.reserve(std::size_t(view.shape[0] * columns));
  for (std::int64_t row = 0; row < view.shape[0]; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) numbers.push_back(number_at(view, row, column));
  }
  return numbers;
}

std::string_view bytes_of(const ArrayView& view, std::size_t place) {
  const bool is_right = view.type == ArrayType::uint8 && columns_of(checked(view, place)) == 1 &&
                        (view.shape[0] < 2 || view.strides[0] == 1);
  if (!is_right) refuse_array(fmt::format("array {} has no bytes; give uint8, one column, without gaps", place));
  return {static_cast<const char*>(view.data), std::size_t(view.shape[0])};
}

std::string read_bytes(const Json& value, const Arrays& arrays) {
  std::string text;
  for (const double byte : to_numbers(value, arrays)) text.push_back(static_cast<char>(static_cast<int>(byte)));
  return text;
}

std::vector<std::int64_t> read_indices(const Json& value, const Arrays& arrays) {
  std::vector<std::int64_t> indices;
  if (is_array_reference(value)) {
    const ArrayView& view = find_column(value, arrays);
    for (std::int64_t row = 0; row < view.shape[0]; ++row) indices.push_back(index_at(view, row));
    return indices;
  }
  if (!value.is_array()) refuse_list(value);
  for (const Json& one : value) indices.push_back(to_index(one, std::ssize(indices)));
  return indices;
}

GeneratorList read_points(const Json& value, const Arrays& arrays, const std::string& name) {
  if (is_array_reference(value)) return to_list(find_array(value, arrays), name);
  if (is_mesh_reference(value)) return to_list_of_mesh(find_column(value, arrays), arrays.input, name);
  if (!value.is_array() || value.empty()) {
    refuse_array(fmt::format("{} is no list of points; give one, or {{\"array\": 0}}", gvd::quoted(value.dump())));
  }
  if (std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_number(); })) {
    GeneratorList list{name, {}};
    for (const std::int64_t vertex : read_indices(value, arrays)) {
      list.entries.push_back({GeneratorEntry::Kind::vertex, vertex, {}, 0});
    }
    return list;
  }
  if (value.front().is_array()) return to_list(value, name);
  if (is_array_reference(value.front()) || is_mesh_reference(value.front())) {
    GeneratorList list{name, {}};
    for (const Json& part : value) {
      const GeneratorList read = read_points(part, arrays, name);
      list.entries.insert(list.entries.end(), read.entries.begin(), read.entries.end());
    }
    return list;
  }
  return parse_objects(value, name);
}

CurveList read_curves(const Json& value, const Arrays& arrays, const std::string& name) {
  if (!value.is_object() || !value.contains("points")) {
    refuse_array(fmt::format("{} is neither boundary, creases, creases:ANGLE nor {{\"points\": ..., \"offsets\": ...}}",
                             gvd::quoted(value.dump())));
  }
  for (const auto& [key, part] : value.items()) {
    if (key != "points" && key != "offsets" && key != "closed")
      refuse_array(fmt::format("curves have no {}", gvd::quoted(key)));
  }
  CurveList list;
  list.points = read_points(value.at("points"), arrays, name);
  const std::int64_t count = std::ssize(list.points.entries);
  std::vector<std::int64_t> offsets{0, count};
  if (value.contains("offsets")) offsets = read_indices(value.at("offsets"), arrays);
  const Json closing = value.value("closed", Json(false));
  if (!closing.is_boolean())
    refuse_array(fmt::format("\"closed\": {} is neither true nor false", gvd::quoted(closing.dump())));
  const bool closed = closing.get<bool>();
  if (offsets.size() < 2 || offsets.front() != 0 || offsets.back() != count) {
    refuse_array(fmt::format("the offsets of curves begin with 0 and end with the number of points, {}", count));
  }
  const auto wrong = std::adjacent_find(offsets.begin(), offsets.end(), std::greater_equal());
  if (wrong != offsets.end()) {
    refuse_array(
        fmt::format("curve {} has no point: it is from offset {} to {}", wrong - offsets.begin(), wrong[0], wrong[1]));
  }
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const std::int64_t first = offsets[c], end = offsets[c + 1];
    list.curve.resize(std::size_t(end), std::int32_t(c));
    for (std::int64_t i = first + 1; i < end; ++i) list.segments.push_back({std::int32_t(i - 1), std::int32_t(i)});
    if (closed && end - first > 2) list.segments.push_back({std::int32_t(end - 1), std::int32_t(first)});
  }
  return list;
}

ElementValues read_numbers(const Json& value, const Arrays& arrays, ValueSource::Of of, const std::string& name) {
  ElementValues given{name, {true, to_numbers(value, arrays)}, true};
  const std::int64_t count = std::ssize(given.soup.values);
  const Mesh& mesh = arrays.input.mesh;
  if (of == ValueSource::Of::generators) return given;
  const bool fits_vertices = count == mesh.vertex_count(), fits_faces = count == mesh.face_count();
  if (fits_vertices || fits_faces) {
    given.soup.of_vertices = of == ValueSource::Of::faces ? !fits_faces : fits_vertices;
    return given;
  }
  if (count != std::ssize(arrays.input.mesh_vertex)) {
    refuse_array(fmt::format("{}; give one for each vertex ({}) or face ({})", counted(count, "number", "numbers"),
                             mesh.vertex_count(), mesh.face_count()));
  }
  given.of_mesh = false;  // a number for each vertex of the file
  return given;
}

}  // namespace gvd
