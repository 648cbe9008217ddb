// Reads GIFTI (.gii), the XML in which programs for brain images exchange surfaces and values of their vertices.
//
// A document is a list of arrays, and the intent of each says what it holds. Points and triangles form a surface; all
// other arrays are values. Numbers are stored as text, in Base64, or as zlib's data in Base64, which the format calls
// GZip. The transform beside the points leads to another space. The reader does not apply it, because it would change
// the shapes of the triangles, and notes that.
// Source: GIFTI Surface Data Format, version 1.0 (January 2011).
// Invariant: no array is used unless it has as many numbers as its dimensions say.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/array_bytes.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/vtk_soup.hpp"

namespace gvd {
namespace {

constexpr std::string_view kPoints = "NIFTI_INTENT_POINTSET", kTriangles = "NIFTI_INTENT_TRIANGLE";

/// The number of bytes that even a small file may expand to. A map with a single region compresses much better than a
/// mesh: the 164,000 equal labels of a hemisphere take 880 digits of Base64, and 2 MB as bytes and numbers. Eight such
/// hemispheres fit.
constexpr std::uint64_t kFree = 1 << 24;

std::string_view intent_of(pugi::xml_node array) { return array.attribute("Intent").value(); }

/// Whether an attribute has a value that the format's document and nibabel spell differently, such as "BigEndian" and
/// "GIFTI_ENDIAN_BIG".
bool is_one_of(pugi::xml_node array, const char* attribute, std::string_view document, std::string_view nibabel) {
  const std::string_view value = array.attribute(attribute).value();
  return value == document || value == nibabel;
}

class GiftiParser {
 public:
  GiftiParser(std::string_view bytes, std::string_view name)
      : name_(name),
        limit_(bytes.size(), name, kFree),
        text_(bytes),
        most_numbers_(kMostExpansion * bytes.size() + kFree) {
    const pugi::xml_parse_result result = document_.load_buffer_inplace(text_.data(), text_.size());
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) refuse(fmt::format("byte {}: the XML is damaged: {}", result.offset, result.description()));
    root_ = document_.child("GIFTI");
    if (!root_) refuse("the XML has no element GIFTI");
  }

  PolygonSoup parse_surface() {
    const pugi::xml_node points = find_array(kPoints), triangles = find_array(kTriangles);
    VtkSoup soup(name_);
    soup.add_points(read_rows_of_three(points));
    VtkCells cells{{}, read_rows_of_three(triangles)};
    for (std::size_t end = 3; end <= cells.corners.size(); end += 3) cells.ends.push_back(double(end));
    soup.add_polygons(cells);
    PolygonSoup made = soup.take();
    note_transforms(points, made.notes);
    const auto arrays = std::distance(root_.children("DataArray").begin(), root_.children("DataArray").end());
    if (arrays > 2) made.notes.push_back(counted(arrays - 2, "array is left out", "arrays are left out"));
    return made;
  }

  std::vector<double> parse_values() {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node array : root_.children("DataArray")) {
      if (intent_of(array) != kPoints && intent_of(array) != kTriangles) found.push_back(array);
    }
    if (found.size() != 1) {
      refuse(fmt::format("the GIFTI file has {} of values; give one with a single array",
                         counted(std::ssize(found), "array", "arrays")));
    }
    if (intent_of(found[0]) == "NIFTI_INTENT_NODE_INDEX") refuse("the GIFTI file has indices of vertices, no values");
    const Shape shape = read_shape(found[0]);
    if (shape.rows != shape.numbers) {
      refuse(fmt::format("the GIFTI file has {} for {}; give one for each", number_count(shape.numbers),
                         counted(std::int64_t(shape.rows), "vertex", "vertices")));
    }
    return read_array(found[0], shape);
  }

 private:
  struct Shape {
    std::uint64_t rows = 0, numbers = 1;
  };

  pugi::xml_node find_array(std::string_view intent) const {
    for (const pugi::xml_node array : root_.children("DataArray")) {
      if (intent_of(array) == intent) return array;
    }
    refuse(fmt::format("the GIFTI file has no array {}; give a surface (.surf.gii)", intent));
  }

  /// Reads the dimensions of an array. The size of the file limits their product.
  Shape read_shape(pugi::xml_node array) const {
    Shape shape;
    const std::uint64_t dimensions = std::min<std::uint64_t>(array.attribute("Dimensionality").as_ullong(), 6);
    for (std::uint64_t i = 0; i < dimensions; ++i) {
      const std::uint64_t size = read_size(array, fmt::format("Dim{}", i));
      if (i == 0) shape.rows = size;
      if (size > most_numbers_ / std::max<std::uint64_t>(shape.numbers, 1)) refuse_size(array, size);
      shape.numbers *= size;
    }
    if (dimensions == 0) refuse(fmt::format("an array {} has no dimensions", quoted(intent_of(array))));
    return shape;
  }

  /// Reads a dimension. A missing dimension is 0, which fits no array.
  std::uint64_t read_size(pugi::xml_node array, const std::string& dimension) const {
    const std::string_view text = array.attribute(dimension.c_str()).value();
    const auto size = parse_count(text);
    if (size || text.find_first_not_of(' ') == text.npos) return size.value_or(0);
    refuse(fmt::format("an array {} has {} {}, and should have a whole number from 0 there; {}",
                       quoted(intent_of(array)), dimension, quoted(text), kExportAgain));
  }

  std::vector<double> read_rows_of_three(pugi::xml_node array) {
    const Shape shape = read_shape(array);
    if (shape.numbers != 3 * shape.rows) {
      refuse(fmt::format("an array {} has {} in {}; three in a row are needed", intent_of(array),
                         number_count(shape.numbers), counted(std::int64_t(shape.rows), "row", "rows")));
    }
    std::vector<double> numbers = read_array(array, shape);
    if (!is_one_of(array, "ArrayIndexingOrder", "ColumnMajorOrder", "GIFTI_IND_ORD_COL_MAJOR")) return numbers;
    std::vector<double> by_row(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) by_row[i] = numbers[i % 3 * shape.rows + i / 3];
    return by_row;
  }

  std::vector<double> read_array(pugi::xml_node array, const Shape& shape) {
    const char* const text = array.child("Data").child_value();
    if (is_one_of(array, "Encoding", "ExternalFileBinary", "GIFTI_ENCODING_EXTBIN")) {
      refuse(fmt::format(
          "the numbers are in another file, {}; write one file, with an encoding other than ExternalFileBinary",
          quoted(array.attribute("ExternalFileName").value())));
    }
    if (!is_one_of(array, "Encoding", "ASCII", "GIFTI_ENCODING_ASCII")) {
      return decode(array, ArrayBytes(text, true), shape.numbers);
    }
    std::vector<double> numbers = parse_array_text(text, quoted(intent_of(array)), name_);
    if (numbers.size() != shape.numbers) refuse_count(array, shape.numbers, number_count(numbers.size()));
    return numbers;
  }

  /// Decodes the `count` numbers of a binary array.
  std::vector<double> decode(pugi::xml_node array, ArrayBytes data, std::uint64_t count) {
    const bool is_packed = is_one_of(array, "Encoding", "GZipBase64Binary", "GIFTI_ENCODING_B64GZ");
    const StoredNumber type = find_type(array, is_packed);
    std::string bytes = data.take(data.most());
    if (data.most() > 0) {
      refuse(fmt::format("the Base64 of an array {} is damaged after byte {}; {}", quoted(intent_of(array)),
                         bytes.size(), kExportAgain));
    }
    if (is_packed) bytes = unpack(array, bytes, count, type);
    if (bytes.size() != count * type.size) refuse_bytes(array, count, type, bytes.size());
    limit_.spend(count * sizeof(double));
    return type.read_all(bytes);
  }

  std::string unpack(pugi::xml_node array, std::string_view packed, std::uint64_t count, const StoredNumber& type) {
    std::string bytes;
    std::uint64_t unused = 0;
    if (append_inflated(bytes, packed, count * type.size, limit_, &unused)) {
      if (unused == 0) return bytes;
      refuse(fmt::format("the packed data of an array {} end after its numbers, but {} them; {}",
                         quoted(intent_of(array)), counted(std::int64_t(unused), "byte follows", "bytes follow"),
                         kExportAgain));
    }
    const std::uint64_t most = most_numbers_ * type.size;
    const auto found = inflated_size(packed, most);
    if (!found || *found == most || *found == count * type.size) {
      refuse(fmt::format("the packed data of an array {} are damaged; {}", quoted(intent_of(array)), kExportAgain));
    }
    refuse_bytes(array, count, type, *found);
  }

  /// How the numbers of a binary array are stored.
  StoredNumber find_type(pugi::xml_node array, bool is_packed) const {
    constexpr std::string_view kPrefix = "NIFTI_TYPE_";
    const std::string_view name = array.attribute("DataType").value();
    const auto type = name.starts_with(kPrefix) ? find_vtk_type(name.substr(kPrefix.size())) : std::nullopt;
    if (!type || (!is_packed && !is_one_of(array, "Encoding", "Base64Binary", "GIFTI_ENCODING_B64BIN"))) {
      refuse(fmt::format("an array {} has the encoding {} and the type {}", quoted(intent_of(array)),
                         quoted(array.attribute("Encoding").value()), quoted(name)));
    }
    return {type->kind, type->size, is_one_of(array, "Endian", "BigEndian", "GIFTI_ENDIAN_BIG")};
  }

  /// Adds a note if a transform is not the identity.
  void note_transforms(pugi::xml_node points, std::vector<std::string>& notes) const {
    constexpr const char* kTransform = "CoordinateSystemTransformMatrix";
    for (const pugi::xml_node transform : points.children(kTransform)) {
      const std::vector<double> matrix = parse_array_text(transform.child_value("MatrixData"), kTransform, name_);
      bool is_identity = matrix.size() == 16;
      for (std::size_t i = 0; i < matrix.size() && is_identity; ++i) is_identity = matrix[i] == (i % 5 == 0 ? 1 : 0);
      if (is_identity) continue;
      notes.push_back(fmt::format("the transform of coordinates from {} to {} is left out",
                                  quoted(transform.child_value("DataSpace")),
                                  quoted(transform.child_value("TransformedSpace"))));
    }
  }

  static std::string number_count(std::uint64_t count) { return counted(std::int64_t(count), "number", "numbers"); }

  /// `found` describes the data.
  [[noreturn]] void refuse_count(pugi::xml_node array, std::uint64_t declared, const std::string& found) const {
    std::string dimensions;
    for (const pugi::xml_attribute attribute : array.attributes()) {
      const std::string_view name = attribute.name();
      if (name.size() != 4 || !name.starts_with("Dim")) continue;
      dimensions += fmt::format("{}{} {}", dimensions.empty() ? "" : ", ", name, quoted(attribute.value()));
    }
    refuse(fmt::format("an array {} should have {} ({}), but its data hold {}; {}", quoted(intent_of(array)),
                       number_count(declared), dimensions, found, kExportAgain));
  }

  [[noreturn]] void refuse_bytes(pugi::xml_node array, std::uint64_t declared, const StoredNumber& type,
                                 std::uint64_t bytes) const {
    const std::uint64_t rest = bytes % type.size;
    refuse_count(array, declared,
                 number_count(bytes / type.size) +
                     (rest == 0 ? "" : " and " + counted(std::int64_t(rest), "more byte", "more bytes")));
  }

  [[noreturn]] void refuse_size(pugi::xml_node array, std::uint64_t size) const {
    refuse(fmt::format("an array {} has Dim0 {} and Dim1 {}: {} in one dimension are more than the file can hold",
                       quoted(intent_of(array)), quoted(array.attribute("Dim0").value()),
                       quoted(array.attribute("Dim1").value()), size));
  }

  [[noreturn]] void refuse(std::string_view message) const {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name_, message));
  }

  std::string name_;
  ExpansionLimit limit_;
  std::string text_;  // the document refers to this text
  std::uint64_t most_numbers_;
  pugi::xml_document document_;
  pugi::xml_node root_;
};

}  // namespace

PolygonSoup parse_gifti(std::string_view bytes, std::string_view name) {
  return GiftiParser(bytes, name).parse_surface();
}

std::vector<double> parse_gifti_values(std::string_view bytes, std::string_view name) {
  return GiftiParser(bytes, name).parse_values();
}

}  // namespace gvd
