// Numbers of vertices or faces: finds the format by the content, and hands the bytes to its reader. NumPy's is here.
//
// A text begins with a character, a FreeSurfer annotation with a zero: the highest byte of a count below 16 million.
// The header of an NPY is a dictionary of Python. Three of its keys are looked for by name, and values follow.
// Files number the vertices and polygons that they hold; a checked mesh has lost some, has triangles for polygons, and
// may have new vertices where edges were split. So values fit by their number: one for each vertex of the mesh's file,
// or one for each polygon. How many polygons it had is known only up to those that the repair removed.
// Source: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", versions 1 to 3.
#include "gvd/read_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/stored_numbers.hpp"

namespace gvd {
namespace {

constexpr std::string_view kNumPyMark = "\x93NUMPY";

[[noreturn]] void refuse_values(std::string_view name, std::string_view message) {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
}

/// The text between two characters behind a key of the header; empty where there is none.
std::string_view find_in_header(std::string_view header, std::string_view key, std::string_view ends) {
  const std::size_t at = header.find(key);
  if (at == header.npos) return {};
  const std::size_t open = header.find(ends[0], at + key.size());
  const std::size_t close = open == header.npos ? open : header.find(ends[1], open + 1);
  return close == header.npos ? std::string_view() : header.substr(open + 1, close - open - 1);
}

/// "<f8": the order of bytes, the kind and the size.
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

/// The number of elements of a shape such as "12," or "1, 12"; none where more than one dimension has several.
std::optional<std::uint64_t> parse_shape(std::string_view shape) {
  std::uint64_t count = 1;
  while (!shape.empty()) {
    const std::size_t end = std::min(shape.find(','), shape.size());
    std::string_view size = shape.substr(0, end);
    shape.remove_prefix(std::min(end + 1, shape.size()));
    size.remove_prefix(std::min(size.find_first_not_of(' '), size.size()));
    if (size.empty() && shape.empty()) break;
    const auto number = parse_number<std::uint64_t>(size);
    if (!number || (count != 1 && *number != 1)) return std::nullopt;
    count *= *number;
  }
  return count;
}

std::vector<double> parse_npy(std::string_view bytes, std::string_view name) {
  constexpr std::size_t kVersion = kNumPyMark.size(), kLength = kVersion + 2;
  const StoredNumber length{StoredNumber::Kind::unsigned_integer,
                            bytes.size() > kVersion && bytes[kVersion] == 1 ? 2U : 4U};
  if (bytes.size() < kLength + length.size) refuse_values(name, "the file ends within NumPy's header");
  const auto header_bytes = std::size_t(length.read(bytes.data() + kLength));
  bytes.remove_prefix(kLength + length.size);
  if (header_bytes > bytes.size()) refuse_values(name, "the file ends within NumPy's header");
  const std::string_view header = bytes.substr(0, header_bytes);
  bytes.remove_prefix(header_bytes);
  const std::string_view type_name = find_in_header(header, "'descr':", "''");
  const auto type = parse_numpy_type(type_name);
  if (!type) refuse_values(name, fmt::format("the array has the type {}, and numbers are needed", quoted(type_name)));
  const std::string_view shape = find_in_header(header, "'shape':", "()");
  const auto count = parse_shape(shape);
  if (!count) {
    refuse_values(name, fmt::format("the array has the shape {}, and one dimension is needed", quoted(shape)));
  }
  if (bytes.size() % type->size != 0 || bytes.size() / type->size != *count) {
    refuse_values(name, fmt::format("the array has {}, and the file {} for them",
                                    counted(std::int64_t(*count), "number", "numbers"),
                                    counted(std::ssize(bytes), "byte", "bytes")));
  }
  return type->read_all(bytes);
}

/// How many polygons the file of the mesh had at least: one more than the last one that became a face.
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

/// Refuses a property that some polygons lack: strips of triangles have none.
void check_count(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  if (property.of_vertices || std::ssize(property.values) >= least_polygons(input)) return;
  refuse_values(name, fmt::format("{} for {}", counted(std::ssize(property.values), "number", "numbers"),
                                  counted(least_polygons(input), "polygon", "polygons")));
}

/// Whether a list has a number for each vertex of the input or for each of its polygons.
SoupProperty assign(const CheckedMesh& input, std::vector<double> values, const std::string& name) {
  const auto count = std::ssize(values);
  if (count == std::ssize(input.mesh_vertex)) return {true, std::move(values)};
  const std::int64_t polygons = least_polygons(input);
  if (count == polygons || (count > polygons && lost_polygons(input))) return {false, std::move(values)};
  refuse_values(name, fmt::format("{}; give one for each vertex ({}) or each face ({})",
                                  counted(count, "number", "numbers"), input.mesh_vertex.size(), polygons));
}

}  // namespace

std::vector<double> parse_values(std::string_view bytes, std::string_view name) {
  if (bytes.starts_with(kNumPyMark)) return parse_npy(bytes, name);
  if (bytes.starts_with(kFreeSurferValues)) return parse_morphometry(bytes, name);
  if (bytes.starts_with(kFreeSurferSurface)) refuse_values(name, "the file is a surface; give values of its vertices");
  if (is_xml_of(bytes, "<GIFTI")) return parse_gifti_values(bytes, name);
  if (bytes.starts_with('\0')) return parse_annotation(bytes, name);
  return parse_numbers(bytes, std::string(name));
}

std::vector<double> read_values(const std::filesystem::path& path) {
  return parse_values(read_file_bytes(path), path.string());
}

std::optional<ElementValues> read_element_values(const CheckedMesh& input, const std::string& name,
                                                 const std::filesystem::path& mesh_file, SoupElement preferred) {
  // Of a file and a property of one name, the file counts.
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    return ElementValues{name, assign(input, read_values(name), name)};
  }
  if (mesh_file.empty()) return std::nullopt;
  std::optional<SoupProperty> property = read_soup_property(mesh_file, name, preferred);
  if (!property) return std::nullopt;
  const std::string title = fmt::format("{}: property {}", mesh_file.string(), name);
  check_count(input, *property, title);
  return ElementValues{title, std::move(*property)};
}

}  // namespace gvd
