// Reads the data of a PLY file, in text and in binary: one walk over its elements, with a source of numbers for each
// encoding.
//
// `read_element` passes each property of an element to its caller, which either reads or skips it. So the soup, single
// properties and attributes share one walk, and refuse a damaged file in the same way.
// Source: G. Turk, The PLY polygon file format, 1994; the files of the Stanford scans, for strips of triangles.
// Invariant: each count is compared with the number of remaining bytes before memory is reserved for it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/read_ply_header.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/stored_numbers.hpp"

namespace gvd {
namespace {

/// Lists the properties of an element for a message: "the list vertex_indices, red". Lists only the first ones of many.
std::string describe_properties(const PlyElement& element) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t p = 0; p < std::min(kMost, element.properties.size()); ++p) {
    const PlyProperty& property = element.properties[p];
    text += fmt::format("{}{}{}", p > 0 ? ", " : "", property.count_type ? "the list " : "", property.name);
  }
  const std::size_t more = element.properties.size() - std::min(kMost, element.properties.size());
  return more > 0 ? fmt::format("{} and {} more", text, more) : text;
}

/// Reads the numbers of a text PLY. Each element begins a line.
class AsciiSource {
 public:
  AsciiSource(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : text_(bytes.substr(header.bytes), name, false) {
    text_.skip_line_numbers(header.lines);
  }

  /// Lower bound on the bytes of an element: a digit and a blank for each property.
  static std::uint64_t least_bytes(const PlyElement& element) { return 2 * element.properties.size(); }
  /// Number of remaining bytes; one more, because the last element may lack its line break.
  std::uint64_t remaining() const { return text_.remaining() + 1; }
  /// Upper bound on the entries of a list, each of which has a digit and a blank, on this line or later.
  std::uint64_t most_entries() const { return (text_.line().size() + 1 + text_.remaining()) / 2; }
  void begin_element(const PlyElement& element, std::int64_t i) {
    if (element.properties.empty() || text_.begin_element()) return;
    text_.refuse_end(fmt::format("and {} {} of {} is missing", element.name, i, element.count), i);
  }
  void end_element(const PlyElement& element, std::int64_t i) {
    if (element.properties.empty()) return;
    text_.end_element(element.name, i);
    const std::string_view extra = text_.token();
    if (extra.empty()) return;
    text_.refuse(fmt::format("{} {} has {} too many; the header declares {}", element.name, i, quoted(extra),
                             describe_properties(element)),
                 i);
  }
  double read(NumberType, const PlyProperty& property) { return text_.number(property.name); }
  void skip(NumberType, std::int64_t count, const PlyProperty& property) {
    for (std::int64_t i = 0; i < count; ++i) text_.number(property.name);
  }
  std::string location() const { return fmt::format("{}", text_.line_number()); }

 private:
  TextReader text_;
};

/// Reads the numbers of a binary PLY.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : bytes_(bytes), name_(name), at_(header.bytes), big_(header.encoding == PlyEncoding::big_endian) {}

  static std::uint64_t least_bytes(const PlyElement& element) {
    std::uint64_t bytes = 0;
    for (const auto& [name, type, count_type] : element.properties) bytes += size_of(count_type.value_or(type));
    return bytes;
  }
  std::uint64_t remaining() const { return bytes_.size() - at_; }
  /// Upper bound on the entries of a list, each of which has at least one byte.
  std::uint64_t most_entries() const { return remaining(); }
  void begin_element(const PlyElement& element, std::int64_t i) { element_ = &element, index_ = i; }
  void end_element(const PlyElement&, std::int64_t) {}

  double read(NumberType type, const PlyProperty& property) {
    require(size_of(type), property);
    using Kind = StoredNumber::Kind;
    const bool is_signed = type == NumberType::int8 || type == NumberType::int16 || type == NumberType::int32;
    const Kind kind = !is_integer(type) ? Kind::real : is_signed ? Kind::signed_integer : Kind::unsigned_integer;
    const StoredNumber stored{kind, size_of(type), big_};
    at_ += stored.size;
    return stored.read(bytes_.data() + at_ - stored.size);
  }
  void skip(NumberType type, std::int64_t count, const PlyProperty& property) {
    const std::uint64_t bytes = size_of(type) * count;
    require(bytes, property);
    at_ += bytes;
  }
  std::string location() const { return fmt::format(" byte {}", at_); }

 private:
  void require(std::uint64_t bytes, const PlyProperty& property) const {
    if (bytes <= remaining()) return;
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: the file ends at byte {}, inside '{}' of {} {} of {}", name_, bytes_.size(),
                            property.name, element_->name, index_, element_->count),
                index_);
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_;
  bool big_;
  const PlyElement* element_ = nullptr;
  std::int64_t index_ = 0;
};

/// The property with the texture coordinates of a face's corners, as MeshLab and VCGlib name it.
constexpr const char* kTextureList = "texcoord";

/// The indices of the two properties of vertices that are texture coordinates, by the names that Blender, MeshLab or
/// other programs use; -1 if there are none.
std::array<int, 2> find_texture_pair(const PlyElement& element) {
  constexpr std::array<std::array<const char*, 2>, 3> kPairs{{{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};
  for (const auto& [first, second] : kPairs) {
    const int u = element.find(first), v = element.find(second);
    const auto is_number = [&](int p) { return p >= 0 && !element.properties[p].count_type; };
    if (is_number(u) && is_number(v)) return {u, v};
  }
  return {-1, -1};
}

/// Whether property p belongs to a texture: a coordinate of a vertex, or the list of the coordinates of a face's
/// corners.
bool is_texture(const PlyElement& element, int p) {
  const auto& [name, type, count_type] = element.properties[p];
  if (element.name == "face") return count_type && name == kTextureList;
  const auto [u, v] = find_texture_pair(element);
  return element.name == "vertex" && (p == u || p == v);
}

bool is_on_mesh(const PlyElement& element) { return element.name == "vertex" || element.name == "face"; }

/// Whether property p of a vertex is a coordinate of its position, or property p of a face is the list of its corners.
bool is_geometry(const PlyElement& element, int p) {
  if (element.name == "face") return p == find_corner_list(element);
  const std::string& name = element.properties[p].name;
  return name == "x" || name == "y" || name == "z";
}

/// Walks over the elements to read surfaces, lines and properties, which share the steps that read an element and
/// refuse damaged data.
template <class Source>
class BodyParser {
 public:
  BodyParser(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : header_(header), source_(bytes, name, header), name_(name) {}

  /// Reads the properties of vertices and faces for which wanted(element, number) holds.
  std::vector<MeshProperty> parse_properties(const std::function<bool(const PlyElement&, int)>& wanted) {
    std::vector<MeshProperty> all;
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.properties.empty()) continue;
      std::vector<MeshProperty> found;  // one for each property; unwanted ones have no name
      for (int p = 0; p < std::ssize(element.properties); ++p) {
        const auto& [name, type, count_type] = element.properties[p];
        found.push_back({wanted(element, p) ? name : "", type, element.name == "vertex", {}, count_type, {}});
        if (count_type) found.back().first_value.push_back(0);
      }
      for (std::int64_t i = 0; i < element.count; ++i) {
        read_element(element, i, [&](int p) {
          if (!found[p].name.empty()) read_values(found[p], element.properties[p], i);
          return !found[p].name.empty();
        });
      }
      std::erase_if(found, [](const MeshProperty& property) { return property.name.empty(); });
      std::move(found.begin(), found.end(), std::back_inserter(all));
    }
    return all;
  }

  LineSoup parse_lines() {
    LineSoup lines;
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        vertices_ = element.count;
        read_vertices(element);
      } else if (!element.properties.empty()) {
        read_edges(element, lines.edges);
      }
    }
    lines.positions = std::move(soup_.positions);
    return lines;
  }

  PolygonSoup parse() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertices_ = element.count;
    }
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else if (!element.properties.empty()) {
        for (std::int64_t i = 0; i < element.count; ++i) read_element(element, i, [](int) { return false; });
      }
    }
    return std::move(soup_);
  }

 private:
  void check_count(const PlyElement& element) const {
    const std::uint64_t least = Source::least_bytes(element);
    if (least == 0 || std::uint64_t(element.count) <= source_.remaining() / least) return;
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: the header promises {} of element '{}', and the file has only {} more bytes", name_,
                            element.count, element.name, source_.remaining()));
  }

  void read_values(MeshProperty& values, const PlyProperty& property, std::int64_t i) {
    const std::int64_t count = property.count_type ? read_count(property, i) : 1;
    for (std::int64_t k = 0; k < count; ++k) values.values.push_back(source_.read(property.type, property));
    if (property.count_type) values.first_value.push_back(values.values.size());
  }

  [[noreturn]] void refuse(ErrorCode code, const std::string& message, std::int64_t element) const {
    throw Error(code, fmt::format("{}:{}: {}", name_, source_.location(), message), element);
  }

  /// Reads element i. take(p) either reads property p and returns true, or returns false, and the property is skipped.
  template <class Take>
  void read_element(const PlyElement& element, std::int64_t i, Take take) {
    source_.begin_element(element, i);
    for (int p = 0; p < std::ssize(element.properties); ++p) {
      const PlyProperty& property = element.properties[p];
      if (take(p)) continue;
      const std::int64_t count = property.count_type ? read_count(property, i) : 1;
      source_.skip(property.type, count, property);
    }
    source_.end_element(element, i);
  }

  std::int64_t read_count(const PlyProperty& property, std::int64_t i) {
    const double count = source_.read(*property.count_type, property);
    if (!(count >= 0) || count != std::floor(count) || count > double(source_.most_entries())) {
      refuse(ErrorCode::unreadable_input,
             fmt::format("the list '{}' announces {} {}, but the file has room for {}", property.name, count,
                         count == 1 ? "entry" : "entries", source_.most_entries()),
             i);
    }
    return std::int64_t(count);
  }

  void read_vertices(const PlyElement& element) {
    check_counts(element.count, 0, name_);
    const std::array<int, 3> xyz = {element.find("x"), element.find("y"), element.find("z")};
    soup_.positions.reserve(element.count);
    for (std::int64_t i = 0; i < element.count; ++i) {
      Vec3 position = Vec3::Zero();
      read_element(element, i, [&](int p) {
        const auto axis = std::find(xyz.begin(), xyz.end(), p) - xyz.begin();
        if (axis == 3) return false;
        const PlyProperty& property = element.properties[p];
        position[axis] = source_.read(property.type, property);
        return true;
      });
      if (!position.allFinite()) {
        refuse(ErrorCode::precondition, fmt::format("a coordinate of vertex {} is not a finite number", i), i);
      }
      soup_.positions.push_back(position);
    }
  }

  void read_faces(const PlyElement& element) {
    check_counts(0, element.count, name_);
    const int list = find_corner_list(element);
    const PlyProperty& property = element.properties[list];
    soup_.corners.reserve(3 * element.count);
    soup_.first_corner.reserve(element.count + 1);
    for (std::int64_t i = 0; i < element.count; ++i) {
      read_element(element, i, [&](int p) {
        if (p != list) return false;
        const std::int64_t size = read_count(property, i);
        for (std::int64_t c = 0; c < size; ++c) {
          soup_.corners.push_back(require_index(source_.read(property.type, property), i, "face"));
        }
        return true;
      });
      soup_.close_polygon();
    }
  }

  /// Reads the element `edge`, and skips all other elements.
  void read_edges(const PlyElement& element, std::vector<std::array<std::int32_t, 2>>& edges) {
    const std::array<int, 2> ends{element.find("vertex1"), element.find("vertex2")};
    for (std::int64_t i = 0; i < element.count; ++i) {
      std::array<std::int32_t, 2> edge{-1, -1};
      read_element(element, i, [&](int p) {
        const auto end = std::find(ends.begin(), ends.end(), p) - ends.begin();
        if (element.name != "edge" || end == 2 || element.properties[p].count_type) return false;
        edge[end] = require_index(source_.read(element.properties[p].type, element.properties[p]), i, "edge");
        return true;
      });
      if (edge[0] >= 0 && edge[1] >= 0) edges.push_back(edge);
    }
  }

  /// Reads strips of triangles: each corner makes a triangle with the two corners before it, and every second triangle
  /// is reversed. The index -1 begins another strip. A triangle with a repeated corner only leads from one strip to the
  /// next.
  void read_strips(const PlyElement& element) {
    const int list = find_corner_list(element);
    const PlyProperty& property = element.properties[list];
    for (std::int64_t i = 0; i < element.count; ++i) {
      read_element(element, i, [&](int p) {
        if (p != list) return false;
        std::array<std::int32_t, 2> last{};
        std::int64_t length = 0;
        for (std::int64_t left = read_count(property, i); left > 0; --left) {
          const double index = source_.read(property.type, property);
          if (index == -1) {
            length = 0;
            continue;
          }
          const std::int32_t corner = require_index(index, i, "strip");
          if (++length > 2)
            add_triangle(length % 2 == 1 ? last[0] : last[1], length % 2 == 1 ? last[1] : last[0], corner);
          last = {last[1], corner};
        }
        return true;
      });
    }
  }

  void add_triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    if (a == b || b == c || c == a) return;
    for (const std::int32_t corner : {a, b, c}) soup_.corners.push_back(corner);
    soup_.close_polygon();
  }

  std::int32_t require_index(double index, std::int64_t face, const char* kind) {
    if (!(index >= 0) || index >= double(vertices_) || index != std::floor(index)) {
      refuse(ErrorCode::unreadable_input,
             fmt::format("{} {} refers to vertex {}, and there are {}", kind, face, index, vertices_), face);
    }
    return std::int32_t(index);
  }

  const PlyHeader& header_;
  Source source_;
  std::string_view name_;
  PolygonSoup soup_;
  std::int64_t vertices_ = 0;
};

/// Gives the soup's corners the texture coordinates of a list of the faces.
void add_corner_texture(const MeshProperty& list, PolygonSoup& soup) {
  if (list.element_count() != soup.polygon_count()) {
    soup.notes.emplace_back("texture coordinates of faces beside strips of triangles: left out");
    return;
  }
  std::int64_t wrong = 0;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const std::size_t corners = soup.polygon(p).size(), first = list.first_value[p];
    const std::size_t numbers = list.first_value[p + 1] - first;
    const bool fits = numbers == 2 * corners;
    wrong += !fits && numbers > 0;
    for (std::size_t i = first; i < first + 2 * corners; i += 2) {
      soup.appearance.texture.push_back(fits ? Uv{list.values[i], list.values[i + 1]} : kNoTexture);
    }
  }
  if (wrong == 0) return;
  soup.notes.push_back(fmt::format("{} not two texture coordinates for each corner: left out",
                                   counted(wrong, "face has", "faces have")));
}

/// Gives the soup its texture from the properties that hold one. Coordinates of vertices count only if corners have no
/// coordinates of their own.
void add_texture(const std::vector<MeshProperty>& properties, PolygonSoup& soup) {
  std::vector<Uv>& texture = soup.appearance.texture;
  const MeshProperty *u = nullptr, *v = nullptr;
  for (const MeshProperty& property : properties) {
    if (property.count_type) add_corner_texture(property, soup);
    const bool is_first = property.name == "s" || property.name == "u" || property.name == "texture_u";
    if (!property.count_type) (is_first ? u : v) = &property;
  }
  const auto is_empty = [&] { return std::ranges::none_of(texture, is_finite); };
  if (is_empty()) texture.clear();
  if (texture.empty() && u != nullptr) {
    for (const std::int32_t corner : soup.corners) texture.push_back({u->values[corner], v->values[corner]});
  }
  if (is_empty()) texture.clear();
}

/// Returns read(parser) with a parser for the encoding that the header names.
template <class Read>
auto read_body(std::string_view bytes, std::string_view name, const PlyHeader& header, const Read& read) {
  return header.encoding == PlyEncoding::ascii ? read(BodyParser<AsciiSource>(bytes, name, header))
                                               : read(BodyParser<BinarySource>(bytes, name, header));
}

/// Whether an element has a property of a texture.
bool has_texture(const PlyHeader& header) {
  return std::ranges::any_of(header.elements, [](const PlyElement& element) {
    for (int p = 0; p < std::ssize(element.properties); ++p) {
      if (is_texture(element, p)) return true;
    }
    return false;
  });
}

/// Reads a texture in a walk of its own, so that files without a texture are read as fast as possible.
void read_texture(std::string_view bytes, std::string_view name, const PlyHeader& header, PolygonSoup& soup) {
  add_texture(read_body(bytes, name, header, [](auto parser) { return parser.parse_properties(is_texture); }), soup);
}

}  // namespace

std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property, std::string_view name,
                                               SoupElement preferred) {
  const PlyHeader header = parse_ply_header(bytes, name);
  const auto find = [&](bool of_vertices) {
    return std::ranges::find_if(header.elements, [&](const PlyElement& e) {
      const int index = is_on_mesh(e) && (e.name == "vertex") == of_vertices ? e.find(property) : -1;
      return index >= 0 && !e.properties[index].count_type;
    });
  };
  for (const bool of_vertices : {preferred == SoupElement::vertex, preferred != SoupElement::vertex}) {
    const auto element = find(of_vertices);
    if (element == header.elements.end()) continue;
    const int index = element->find(property);
    const auto wanted = [&](const PlyElement& other, int p) { return &other == &*element && p == index; };
    auto found = read_body(bytes, name, header, [&](auto parser) { return parser.parse_properties(wanted); });
    return SoupProperty{found.front().of_vertices, std::move(found.front().values)};
  }
  return std::nullopt;
}

std::vector<MeshProperty> parse_ply_properties(std::string_view bytes, std::string_view name) {
  const auto wanted = [](const PlyElement& e, int p) {
    return is_on_mesh(e) && !is_geometry(e, p) && !is_texture(e, p);
  };
  return read_body(bytes, name, parse_ply_header(bytes, name),
                   [&](auto parser) { return parser.parse_properties(wanted); });
}

std::vector<MeshProperty> parse_ply_vertices(std::string_view bytes, std::string_view name) {
  PlyHeader header = parse_ply_header(bytes, name, PlyContent::points);
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  header.elements.erase(vertex + 1, header.elements.end());
  const auto wanted = [](const PlyElement& e, int p) { return e.name == "vertex" && !e.properties[p].count_type; };
  return read_body(bytes, name, header, [&](auto parser) { return parser.parse_properties(wanted); });
}

LineSoup parse_ply_lines(std::string_view bytes, std::string_view name) {
  return read_body(bytes, name, parse_ply_header(bytes, name, PlyContent::lines),
                   [](auto parser) { return parser.parse_lines(); });
}

PolygonSoup parse_ply(std::string_view bytes, std::string_view name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  PolygonSoup soup = read_body(bytes, name, header, [](auto parser) { return parser.parse(); });
  if (has_texture(header)) read_texture(bytes, name, header, soup);
  if (header.has_images) soup.appearance.unread.emplace_back(kUnreadImages);
  return soup;
}

}  // namespace gvd
