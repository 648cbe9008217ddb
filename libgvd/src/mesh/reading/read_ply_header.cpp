// Reads the header of a PLY file: its encoding, and the elements and properties of its data.
//
// Source: G. Turk, The PLY polygon file format, 1994; files of scanners, for types such as int32, the list vertex_index
// and strips of triangles.
// Invariant: the length of the header is exact, because binary data follow it immediately. All its lines end like the
// first one.
#include "mesh/reading/read_ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

std::optional<NumberType> parse_type(std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames = {{{"char", "int8"},
                                                                      {"uchar", "uint8"},
                                                                      {"short", "int16"},
                                                                      {"ushort", "uint16"},
                                                                      {"int", "int32"},
                                                                      {"uint", "uint32"},
                                                                      {"float", "float32"},
                                                                      {"double", "float64"}}};
  const auto it = std::ranges::find_if(kNames, [&](const auto& name) { return name[0] == word || name[1] == word; });
  if (it == kNames.end()) return std::nullopt;
  return static_cast<NumberType>(it - kNames.begin());
}

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, std::string_view name, PlyContent content)
      : text_(header_bytes(bytes), name, false), size_(header_bytes(bytes).size()), content_(content) {}

  PlyHeader parse() {
    if (!text_.next_line() || text_.token() != "ply") text_.refuse("the first line of a PLY file should be ply");
    bool ended = false;
    while (!ended && text_.next_line()) ended = parse_line();
    if (!ended) text_.refuse_end("and end_header is missing");
    if (!has_format_) text_.refuse("the header has no line 'format'");
    check_elements();
    header_.bytes = size_;
    header_.lines = text_.line_number();
    return std::move(header_);
  }

 private:
  static std::string_view header_bytes(std::string_view bytes) {
    const std::size_t first = bytes.find_first_of("\r\n");
    if (first == std::string_view::npos) return bytes;
    const std::string_view line_end = bytes.substr(first, bytes.substr(first).starts_with("\r\n") ? 2 : 1);
    for (std::size_t at = bytes.find("end_header"); at != std::string_view::npos;
         at = bytes.find("end_header", at + 1)) {
      if (at == 0 || bytes[at - 1] != line_end.back()) continue;
      const std::size_t end = bytes.find(line_end, at);
      // There is none after a later end_header either, and searching again would take O(n^2).
      if (end == std::string_view::npos) break;
      return bytes.substr(0, end + line_end.size());
    }
    return bytes;
  }

  /// Parses the current line. Returns true at end_header.
  bool parse_line() {
    const std::string_view word = text_.token();
    if (word == "end_header") return true;
    if (word == "format") {
      parse_format();
    } else if (word == "element") {
      parse_element();
    } else if (word == "property") {
      parse_property();
    } else if (word == "comment") {
      header_.has_images |= text_.token() == "TextureFile";
    } else if (word != "obj_info" && !word.empty()) {
      text_.refuse(fmt::format("{} is not a statement of a PLY header", quoted(word)));
    }
    return false;
  }

  void parse_format() {
    const std::string_view word = text_.token();
    constexpr std::array<std::string_view, 3> kEncodings = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto it = std::find(kEncodings.begin(), kEncodings.end(), word);
    if (it == kEncodings.end()) {
      text_.refuse(
          fmt::format("the format {} is none of ascii, binary_little_endian and binary_big_endian", quoted(word)));
    }
    header_.encoding = static_cast<PlyEncoding>(it - kEncodings.begin());
    has_format_ = true;
  }

  void parse_element() {
    const std::string_view name = text_.token();
    const std::int64_t count = text_.integer("the number of elements");
    if (count < 0) text_.refuse(fmt::format("the number of elements is {}", count));
    if (!names_.insert(name).second) text_.refuse(fmt::format("the element {} is declared twice", quoted(name)));
    header_.elements.push_back({printable(name), count, {}});
  }

  void parse_property() {
    if (header_.elements.empty()) text_.refuse("a property comes before the first element");
    PlyProperty property;
    std::string_view word = text_.token();
    if (word == "list") {
      property.count_type = require_type(text_.token());
      if (!is_integer(*property.count_type)) text_.refuse("the count of a list should have an integer type");
      word = text_.token();
    }
    property.type = require_type(word);
    property.name = printable(text_.token());
    if (property.name.empty()) text_.refuse("the property has no name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  NumberType require_type(std::string_view word) const {
    const std::optional<NumberType> type = parse_type(word);
    if (!type) text_.refuse(fmt::format("{} is not a type of a PLY property", quoted(word)));
    return *type;
  }

  void check_elements() const {
    const auto vertex = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
    if (vertex == header_.elements.end()) text_.refuse("the header has no element 'vertex'");
    for (const std::string_view name : {"x", "y", "z"}) {
      const int at = vertex->find(name);
      if (at < 0 || vertex->properties[at].count_type) {
        text_.refuse(fmt::format("the element 'vertex' has no number '{}'", name));
      }
    }
    if (content_ == PlyContent::points) return;
    if (content_ == PlyContent::lines) return check_edges();
    bool has_faces = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name != "face" && element.name != "tristrips") continue;
      has_faces = true;
      const int list = find_corner_list(element);
      if (list < 0 || !element.properties[list].count_type) {
        text_.refuse(fmt::format("the element '{}' has no list 'vertex_indices' or 'vertex_index'", element.name));
      }
    }
    if (!has_faces) text_.refuse("the header has neither an element 'face' nor 'tristrips'; a surface is needed");
  }

  void check_edges() const {
    const auto edge = std::ranges::find(header_.elements, "edge", &PlyElement::name);
    if (edge == header_.elements.end() || edge->find("vertex1") < 0 || edge->find("vertex2") < 0) {
      text_.refuse("the header has no element 'edge' with vertex1 and vertex2; curves are needed");
    }
  }

  TextReader text_;
  std::size_t size_;
  PlyContent content_;
  PlyHeader header_;
  std::set<std::string_view> names_;  // of the elements
  bool has_format_ = false;
};

}  // namespace

int PlyElement::find(std::string_view property) const {
  const auto it = std::ranges::find(properties, property, &PlyProperty::name);
  return it == properties.end() ? -1 : static_cast<int>(it - properties.begin());
}

PlyHeader parse_ply_header(std::string_view bytes, std::string_view name, PlyContent content) {
  return HeaderParser(bytes, name, content).parse();
}

}  // namespace gvd
