// Reads a number for each vertex or face: finds the format by the content, and passes the bytes to its reader. The
// reader of NumPy's arrays is in this file.
//
// A text is a table if it has a header with a column `face` or `vertex`, and a list of numbers otherwise.
// A text begins with a character, whereas a FreeSurfer annotation begins with a zero, the highest byte of a count below
// 16 million. The header of an NPY is a Python dictionary. The reader searches it for the names of three keys.
// Values belong to the vertices and polygons of a file, but the checked mesh may have lost some, has triangles in place
// of polygons, and may have new vertices where edges were split. So the count of the values decides what they belong
// to: the vertices of the mesh's file, its polygons, or the vertices or faces of the checked mesh. The number of
// polygons in the file is not known exactly if the repair removed some.
// Source: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", versions 1 to 3.
#include "gvd/read_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "io/parse_lists.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/stored_numbers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

constexpr std::string_view kNumPyMark = "\x93NUMPY";

[[noreturn]] void refuse_values(std::string_view name, std::string_view message) {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
}

/// The text between two characters after a key of the header; empty if there is none.
std::string_view find_in_header(std::string_view header, std::string_view key, std::string_view ends) {
  const std::size_t at = header.find(key);
  if (at == header.npos) return {};
  const std::size_t open = header.find(ends[0], at + key.size());
  const std::size_t close = open == header.npos ? open : header.find(ends[1], open + 1);
  return close == header.npos ? std::string_view() : header.substr(open + 1, close - open - 1);
}

/// The word after a key of the header, with or without blanks between them.
std::string_view word_in_header(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == header.npos) return {};
  std::string_view rest = header.substr(at + key.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return rest.substr(0, rest.find_first_of(" ,}"));
}

/// Parses a type such as "<f8": byte order, kind and size.
std::optional<StoredNumber> parse_numpy_type(std::string_view type) {
  using NumberKind = StoredNumber::Kind;
  if (type.size() != 3 || std::string_view("<>|=").find(type[0]) == type.npos) return std::nullopt;
  const auto size = std::size_t(type[2] - '0');
  const bool is_real = type[1] == 'f';
  if (std::string_view("fiub").find(type[1]) == type.npos) return std::nullopt;
  if (size != 8 && size != 4 && (is_real || (size != 2 && size != 1))) return std::nullopt;
  return StoredNumber{is_real          ? NumberKind::real
                      : type[1] == 'i' ? NumberKind::signed_integer
                                       : NumberKind::unsigned_integer,
                      size, type[0] == '>'};
}

/// The numbers of a file, and whether they belong to vertices or faces if the file says so.
struct FileValues {
  std::optional<bool> of_vertices;  ///< otherwise of faces
  std::vector<double> values;
};

/// The rows and columns of an array.
struct ArrayShape {
  std::uint64_t rows = 1, columns = 1;
};

/// Parses a shape such as "12,", "1, 12" or "12, 3". If only one dimension has several elements, it counts as the rows.
/// Returns nothing if more than two dimensions have several elements, or if the array is too large.
std::optional<ArrayShape> parse_shape(std::string_view shape) {
  std::vector<std::uint64_t> several;
  std::uint64_t count = 1;
  while (!shape.empty()) {
    const std::size_t end = std::min(shape.find(','), shape.size());
    std::string_view size = shape.substr(0, end);
    shape.remove_prefix(std::min(end + 1, shape.size()));
    size.remove_prefix(std::min(size.find_first_not_of(' '), size.size()));
    if (size.empty() && shape.empty()) break;
    const auto number = parse_number<std::uint64_t>(size);
    constexpr std::uint64_t kMost = std::uint64_t{1} << 53;
    if (!number || *number > kMost / std::max<std::uint64_t>(count, 1)) return std::nullopt;
    count *= *number;
    if (*number != 1) several.push_back(*number);
  }
  if (several.size() > 2) return std::nullopt;
  several.resize(2, 1);
  return ArrayShape{several[0], several[1]};
}

/// `columns`: how to treat an array with several columns.
FileValues parse_npy(std::string_view bytes, ValueColumns columns, std::string_view name) {
  constexpr std::size_t kVersion = kNumPyMark.size(), kLength = kVersion + 2;
  const StoredNumber length{StoredNumber::Kind::unsigned_integer,
                            bytes.size() > kVersion && bytes[kVersion] == 1 ? 2U : 4U};
  if (bytes.size() < kLength + length.size) refuse_values(name, "the file ends within NumPy's header");
  if (const int version = bytes[kVersion]; version < 1 || version > 3) {
    refuse_values(name, fmt::format("the file has version {} of NumPy's format, and 1 to 3 are read", version));
  }
  const auto header_bytes = std::size_t(length.read(bytes.data() + kLength));
  bytes.remove_prefix(kLength + length.size);
  if (header_bytes > bytes.size()) refuse_values(name, "the file ends within NumPy's header");
  const std::string_view header = bytes.substr(0, header_bytes);
  bytes.remove_prefix(header_bytes);
  const std::string_view type_name = find_in_header(header, "'descr':", "''");
  const auto type = parse_numpy_type(type_name);
  if (!type) refuse_values(name, fmt::format("the array has the type {}, and numbers are needed", quoted(type_name)));
  const std::string_view text = find_in_header(header, "'shape':", "()");
  const auto shape = parse_shape(text);
  if (!shape || (shape->columns != 1 && columns == ValueColumns::one)) {
    refuse_values(name, fmt::format("the array has the shape {}, and one dimension is needed", quoted(text)));
  }
  const std::uint64_t count = shape->rows * shape->columns;
  if (bytes.size() % type->size != 0 || bytes.size() / type->size != count) {
    refuse_values(name, fmt::format("the array has {}, and the file {} for them",
                                    counted(std::int64_t(count), "number", "numbers"),
                                    counted(std::ssize(bytes), "byte", "bytes")));
  }
  if (shape->columns <= 1) return {{}, type->read_all(bytes)};
  // Numbers are stored row by row, unless the header says column by column.
  const bool by_columns = word_in_header(header, "'fortran_order':") == "True";
  const std::uint64_t first = by_columns ? (shape->columns - 1) * shape->rows : shape->columns - 1;
  const std::uint64_t step = by_columns ? 1 : shape->columns;
  std::vector<double> last(shape->rows);
  for (std::uint64_t r = 0; r < shape->rows; ++r) last[r] = type->read(bytes.data() + (first + r * step) * type->size);
  return {{}, std::move(last)};
}

FileValues parse_table(std::string_view text, ValueColumns columns, const std::string& name) {
  detail::ElementTable table = detail::parse_element_table(text, name);
  if (table.columns != 1 && columns == ValueColumns::one) {
    refuse_values(name, fmt::format("the table has {} columns of numbers, and one is needed", table.columns));
  }
  return {table.of_vertices, std::move(table.numbers)};
}

FileValues parse_file(std::string_view bytes, ValueColumns columns, std::string_view name) {
  if (is_utf16(bytes)) return parse_file(to_utf8(bytes), columns, name);
  if (bytes.starts_with(kNumPyMark)) return parse_npy(bytes, columns, name);
  if (bytes.starts_with(kFreeSurferValues)) return {true, parse_morphometry(bytes, name)};
  if (bytes.starts_with(kFreeSurferSurface)) refuse_values(name, "the file is a surface; give values of its vertices");
  if (is_xml_of(bytes, "<GIFTI")) return {{}, parse_gifti_values(bytes, name)};
  if (bytes.starts_with('\0')) return {true, parse_annotation(bytes, name)};
  if (detail::is_element_table(bytes)) return parse_table(bytes, columns, std::string(name));
  detail::refuse_other_table(bytes, std::string(name));
  return {{}, parse_numbers(bytes, std::string(name))};
}

/// A lower bound for the number of polygons in the mesh's file: one more than the last polygon that became a face.
std::int64_t least_polygons(const CheckedMesh& input) {
  return 1 + *std::max_element(input.input_polygon.begin(), input.input_polygon.end());
}

/// Whether the repair removed polygons, so that the file may have had more.
bool lost_polygons(const CheckedMesh& input) {
  return input.defects.count(DefectKind::degenerate_faces) + input.defects.count(DefectKind::duplicate_faces) +
             input.defects.count(DefectKind::dropped_components) +
             input.defects.count(DefectKind::zero_area_components) >
         0;
}

/// Refuses a property that some polygons lack, as strips of triangles do.
void check_count(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  if (property.of_vertices || std::ssize(property.values) >= least_polygons(input)) return;
  refuse_values(name, fmt::format("{} for {}", counted(std::ssize(property.values), "number", "numbers"),
                                  counted(least_polygons(input), "polygon", "polygons")));
}

/// Decides by the count of numbers what they belong to: the vertices of the input's file, its polygons, or the vertices
/// or faces of the repaired mesh, for which this library writes numbers. If the count fits several of them and the file
/// does not say which, the first in this order wins.
ElementValues assign(const CheckedMesh& input, FileValues&& found, const std::string& name) {
  const auto count = std::ssize(found.values);
  const bool may_be_vertices = found.of_vertices.value_or(true), may_be_faces = !found.of_vertices.value_or(false);
  const auto make = [&](bool of_vertices, bool of_mesh) {
    return ElementValues{name, {of_vertices, std::move(found.values)}, of_mesh};
  };
  if (may_be_vertices && count == std::ssize(input.mesh_vertex)) return make(true, false);
  const std::int64_t polygons = least_polygons(input);
  if (may_be_faces && count == polygons) return make(false, false);
  if (may_be_vertices && count == input.mesh.vertex_count()) return make(true, true);
  if (may_be_faces && count == input.mesh.face_count()) return make(false, true);
  if (may_be_faces && count > polygons && lost_polygons(input)) return make(false, false);
  refuse_values(name, fmt::format("{}; give one for each vertex ({}) or each face ({})",
                                  counted(count, "number", "numbers"), input.mesh_vertex.size(), polygons));
}

}  // namespace

std::vector<double> parse_values(std::string_view bytes, std::string_view name) {
  return parse_file(bytes, ValueColumns::one, name).values;
}

std::vector<double> read_values(const std::filesystem::path& path) {
  return parse_values(read_file_bytes(path), path.string());
}

std::optional<ElementValues> read_element_values(const CheckedMesh& input, const std::string& name,
                                                 const std::filesystem::path& mesh_file, SoupElement preferred,
                                                 ValueColumns columns) {
  // A file or pipe takes precedence over a property of the same name.
  std::error_code ignored;
  const auto status = std::filesystem::status(name, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_directory(status)) {
    return assign(input, parse_file(read_file_bytes(name), columns, name), name);
  }
  if (mesh_file.empty()) return std::nullopt;
  std::optional<SoupProperty> property = read_soup_property(mesh_file, name, preferred);
  if (!property) return std::nullopt;
  const std::string title = fmt::format("{}: property {}", mesh_file.string(), name);
  check_count(input, *property, title);
  return ElementValues{title, std::move(*property)};
}

}  // namespace gvd
