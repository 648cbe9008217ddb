// Reads values of options from arrays beside JSON.
//
// Every numeric type is accepted for every option, because languages differ in the type that they give a list of
// numbers. The shape tells what is meant, and lists in JSON are read like arrays. The results are entries as in files,
// which resolve_generators and resolve_curves check as they check files.

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
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_array(const std::string& text) { throw Error(ErrorCode::invalid_option, text); }

/// A value in quotes, for messages.
std::string shown(const Json& value) {
  return gvd::quoted(value.is_string() ? value.get_ref<const std::string&>() : value.dump());
}

/// A number as it was given. Doubles can't hold all large whole numbers.
struct GivenNumber {
  double value;
  std::int64_t whole = -1;  ///< the number if its type is integral; if below 0, use `value`
};

template <class T>
GivenNumber load(const std::byte* place) {
  T value;
  std::memcpy(&value, place, sizeof value);
  if constexpr (std::is_integral_v<T>) return {static_cast<double>(value), static_cast<std::int64_t>(value)};
  return {static_cast<double>(value)};
}

/// For each ArrayType, in their order.
constexpr std::array<GivenNumber (*)(const std::byte*), 10> kLoad{
    load<std::int8_t>,   load<std::uint8_t>, load<std::int16_t>,  load<std::uint16_t>, load<std::int32_t>,
    load<std::uint32_t>, load<std::int64_t>, load<std::uint64_t>, load<float>,         load<double>};
static_assert(std::size_t(ArrayType::float64) + 1 == kLoad.size());

std::int64_t columns_of(const ArrayView& view) { return view.dimensions == 2 ? view.shape[1] : 1; }

/// Refuses an array with an invalid type or shape.
void check_array(const ArrayView& view, std::size_t place) {
  const auto type = static_cast<std::int32_t>(view.type);
  if (type < 0 || std::size_t(type) >= kLoad.size()) {
    refuse_array(fmt::format("array {} has no known type: {}", place, type));
  }
  if (view.dimensions < 1 || view.dimensions > 2) {
    refuse_array(fmt::format("array {} has {} dimensions; give 1 or 2", place, view.dimensions));
  }
  if (view.shape[0] < 0 || columns_of(view) < 0) refuse_array(fmt::format("array {} has a negative length", place));
  if (std::max(view.shape[0], columns_of(view)) > std::numeric_limits<std::int32_t>::max()) {
    refuse_array(fmt::format("array {} has more elements than a mesh can have", place));
  }
  if (view.data == nullptr && view.shape[0] > 0) refuse_array(fmt::format("array {} is NULL", place));
}

/// The number of the array to which a value such as {"array": 0} refers.
std::size_t find_array(const Json& value, const Arrays& arrays) {
  const Json& place = value.front();
  const std::int64_t count = std::ssize(arrays.views);
  if (place.is_number_integer() && place.get<std::int64_t>() >= 0 && place.get<std::int64_t>() < count) {
    return place.get<std::size_t>();
  }
  refuse_array(fmt::format("there is no array {}; {} given", place.dump(), counted(count, "array is", "arrays are")));
}

std::int64_t to_index(const GivenNumber& number, std::int64_t row) {
  const double value = number.value;
  if (number.whole >= 0) return number.whole;
  if (value >= 0 && value == std::floor(value) && value < kMostWhole) return static_cast<std::int64_t>(value);
  throw Error(ErrorCode::invalid_option, fmt::format("element {} is {}; give whole numbers from 0 on", row, value),
              row);
}

/// Reads a number of JSON, which may be a string, because JSON has no infinity.
GivenNumber to_number(const Json& value) {
  if (value.is_number_integer()) return {value.get<double>(), value.get<std::int64_t>()};
  if (value.is_number()) return {value.get<double>()};
  const auto parsed = value.is_string() ? parse_number<double>(value.get_ref<const std::string&>()) : std::nullopt;
  if (!parsed) refuse_array(fmt::format("{} is not a number", shown(value)));
  return {*parsed};
}

/// Calls take(number) for all numbers of an array, row by row.
template <class Take>
void for_each_number(const ArrayView& view, std::size_t place, const Take& take) {
  check_array(view, place);
  for (std::int64_t row = 0; row < view.shape[0]; ++row) {
    const auto* const first = static_cast<const std::byte*>(view.data) + row * view.strides[0];
    for (std::int64_t column = 0; column < columns_of(view); ++column) {
      take(kLoad[std::size_t(view.type)](first + column * view.strides[1]));
    }
  }
}

/// Numbers in rows, from an array or from a list of numbers or lists.
struct NumberRows {
  std::vector<GivenNumber> numbers;
  std::int64_t columns;
};

NumberRows read_rows(const Json& value, const Arrays& arrays) {
  if (is_array_reference(value) || is_mesh_reference(value)) {
    const std::size_t place = find_array(value, arrays);
    NumberRows rows{{}, columns_of(arrays.views[place])};
    for_each_number(arrays.views[place], place, [&](const GivenNumber& number) { rows.numbers.push_back(number); });
    return rows;
  }
  if (!value.is_array()) {
    refuse_array(fmt::format("{} is not a list of numbers; give one, or {{\"array\": 0}}", shown(value)));
  }
  const bool has_rows = !value.empty() && value.front().is_array();
  NumberRows rows{{}, has_rows ? std::ssize(value.front()) : 1};
  for (const Json& row : value) {
    if (has_rows && (!row.is_array() || std::ssize(row) != rows.columns)) {
      refuse_array(fmt::format("{} is not a row of {} numbers like the first point", shown(row), rows.columns));
    }
    if (!has_rows) rows.numbers.push_back(to_number(row));
    for (std::int64_t i = 0; has_rows && i < rows.columns; ++i) rows.numbers.push_back(to_number(row[std::size_t(i)]));
  }
  return rows;
}

std::vector<GivenNumber> read_column(const Json& value, const Arrays& arrays) {
  NumberRows rows = read_rows(value, arrays);
  if (rows.columns == 1) return std::move(rows.numbers);
  refuse_array(fmt::format("the array has {} columns; give one number each", rows.columns));
}

/// Makes points of rows, which are vertices, positions, or faces with barycentric coordinates.
GeneratorList to_list(const NumberRows& rows, const std::string& name) {
  using Kind = GeneratorEntry::Kind;
  const auto& [numbers, columns] = rows;
  if (columns != 1 && columns != 3 && columns != 4) {
    refuse_array(fmt::format(
        "points have {} columns; give vertices, positions in 3 columns, or faces and barycentric coordinates in 4",
        columns));
  }
  GeneratorList list{name, {}};
  for (auto row = numbers.begin(); row != numbers.end(); row += columns) {
    const std::int64_t index = columns == 3 ? 0 : to_index(*row, std::ssize(list.entries));
    const auto at = row + (columns == 4 ? 1 : 0);
    list.entries.push_back(
        columns == 1
            ? GeneratorEntry{Kind::vertex, index, {}, 0}
            : GeneratorEntry{
                  columns == 3 ? Kind::position : Kind::face, index, {at[0].value, at[1].value, at[2].value}, 0});
  }
  if (list.entries.empty()) refuse_array("there is no point");
  return list;
}

/// Makes points of vertices of the mesh, with their numbers in the input. Copies that the repair made have no such
/// number, and become corners of faces.
GeneratorList to_list_of_mesh(const std::vector<GivenNumber>& vertices, const CheckedMesh& input,
                              const std::string& name) {
  GeneratorList list{name, {}};
  const std::int32_t count = input.mesh.vertex_count();
  for (const GivenNumber& number : vertices) {
    const std::int64_t row = std::ssize(list.entries), index = to_index(number, row);
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

/// Parses points in the form of JSON files, such as {"vertex": 3}.
GeneratorList parse_objects(const Json& value, const std::string& name) {
  const auto odd = std::ranges::find_if(value, [](const Json& one) { return !one.is_object(); });
  if (odd != value.end()) {
    refuse_array(
        fmt::format("{} is not an object like the first point; write {{\"vertex\": 3}} or {{\"position\": [x, y, z]}}",
                    shown(*odd)));
  }
  try {
    GeneratorList list = parse_generators(Json{{"generators", value}}.dump(), GeneratorFormat::json, name);
    for (GeneratorEntry& entry : list.entries) entry.line = 0;  // no file, so no line
    return list;
  } catch (const Error& error) {
    std::string text = error.text();
    const std::string line = name + ":1: ";  // refers to the generated text, which the user has not written
    if (text.starts_with(line)) text.replace(0, line.size(), name + ": ");
    throw Error(ErrorCode::invalid_option, text, error.element());
  }
}

}  // namespace

bool is_mesh_reference(const Json& value) {
  return value.is_object() && value.size() == 1 && value.contains("mesh_vertices");
}

bool is_array_reference(const Json& value) { return value.is_object() && value.size() == 1 && value.contains("array"); }

std::vector<double> read_array(const ArrayView& view, std::size_t place) {
  std::vector<double> numbers;
  for_each_number(view, place, [&](const GivenNumber& number) { numbers.push_back(number.value); });
  return numbers;
}

std::string_view bytes_of(const ArrayView& view, std::size_t place) {
  check_array(view, place);
  const bool is_right =
      view.type == ArrayType::uint8 && columns_of(view) == 1 && (view.shape[0] < 2 || view.strides[0] == 1);
  if (!is_right)
    refuse_array(fmt::format("array {} does not contain bytes; give uint8, one column, without gaps", place));
  return {static_cast<const char*>(view.data), std::size_t(view.shape[0])};
}

std::string read_bytes(const Json& value, const Arrays& arrays) {
  std::string text;
  for (const GivenNumber& byte : read_column(value, arrays)) text.push_back(static_cast<char>(int(byte.value)));
  return text;
}

std::vector<std::int64_t> read_indices(const Json& value, const Arrays& arrays) {
  std::vector<std::int64_t> indices;
  for (const GivenNumber& number : read_column(value, arrays)) {
    indices.push_back(to_index(number, std::ssize(indices)));
  }
  return indices;
}

GeneratorList read_points(const Json& value, const Arrays& arrays, const std::string& name) {
  if (is_array_reference(value)) return to_list(read_rows(value, arrays), name);
  if (is_mesh_reference(value)) return to_list_of_mesh(read_column(value, arrays), arrays.input, name);
  if (!value.is_array() || value.empty()) {
    refuse_array(fmt::format("{} is not a list of points; give one, or {{\"array\": 0}}", shown(value)));
  }
  const bool has_numbers = std::ranges::all_of(value, [](const Json& one) { return one.is_number(); });
  if (has_numbers || value.front().is_array()) return to_list(read_rows(value, arrays), name);
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
                             shown(value)));
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
  if (!closing.is_boolean()) refuse_array(fmt::format("\"closed\": {} is neither true nor false", shown(closing)));
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
  ElementValues given{name, {true, {}}, true};
  for (const GivenNumber& number : read_column(value, arrays)) given.soup.values.push_back(number.value);
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
  given.of_mesh = false;  // the numbers belong to the vertices of the file
  return given;
}

}  // namespace gvd
