#include "mesh/reading/read_ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/printable.hpp"
#include "gvd/error.hpp"
#include "mesh/reading/check_counts.hpp"
#include "mesh/reading/read_ply_header.hpp"
#include "mesh/reading/read_text.hpp"

namespace gvd {
namespace {

// Reads the numbers of a text PLY. Each element begins a line.
class AsciiSource {
 public:
  AsciiSource(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : text_(bytes.substr(header.bytes), name, false) {
    text_.skip_line_numbers(header.lines);
  }

  // The fewest bytes that an element can have: a digit and a blank for each property.
  static std::uint64_t least_bytes(const PlyElement& element) { return 2 * element.properties.size(); }
  // The last element may lack its line break.
  std::uint64_t remaining() const { return text_.remaining() + 1; }
  // Upper bound on the entries of a list: each has a digit and a blank, on this line or later.
  std::uint64_t most_entries() const { return (text_.line().size() + 1 + text_.remaining()) / 2; }
  void begin_element(const PlyElement& element, std::int64_t i) {
    if (element.properties.empty() || text_.begin_element()) return;
    text_.refuse_end(fmt::format("and {} {} of {} is missing", element.name, i, element.count), i);
  }
  void end_element(const PlyElement& element, std::int64_t i) {
    if (element.properties.empty()) return;
    text_.end_element(element.name, i);
    const std::string_view extra = text_.token();
    if (!extra.empty()) text_.refuse(fmt::format("{} {} has {} too many", element.name, i, quoted(extra)), i);
  }
  double read(PlyType, const PlyProperty& property) { return text_.number(property.name); }
  void skip(PlyType, std::int64_t count, const PlyProperty& property) {
    for (std::int64_t i = 0; i < count; ++i) text_.number(property.name);
  }
  std::string location() const { return fmt::format("{}", text_.line_number()); }

 private:
  TextReader text_;
};

// Reads the numbers of a binary PLY.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : bytes_(bytes), name_(name), at_(header.bytes), big_(header.encoding == PlyEncoding::big_endian) {}

  static std::uint64_t least_bytes(const PlyElement& element) {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += size_of(property.count_type.value_or(property.type));
    return bytes;
  }
  std::uint64_t remaining() const { return bytes_.size() - at_; }
  // Upper bound on the entries of a list: each has at least one byte.
  std::uint64_t most_entries() const { return remaining(); }
  void begin_element(const PlyElement& element, std::int64_t i) { element_ = &element, index_ = i; }
  void end_element(const PlyElement&, std::int64_t) {}

  double read(PlyType type, const PlyProperty& property) {
    require(size_of(type), property);
    const std::uint64_t bits = take(size_of(type));
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::uint8:
        return static_cast<std::uint8_t>(bits);
      case PlyType::int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::uint16:
        return static_cast<std::uint16_t>(bits);
      case PlyType::int32:
        return static_cast<std::int32_t>(bits);
      case PlyType::uint32:
        return static_cast<std::uint32_t>(bits);
      case PlyType::float32:
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      case PlyType::float64:
        return std::bit_cast<double>(bits);
    }
    return 0;
  }
  void skip(PlyType type, std::int64_t count, const PlyProperty& property) {
    const std::uint64_t bytes = size_of(type) * static_cast<std::uint64_t>(count);
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

  std::uint64_t take(std::size_t size) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = static_cast<unsigned char>(bytes_[at_ + (big_ ? i : size - 1 - i)]);
      bits = bits << 8 | byte;
    }
    at_ += size;
    return bits;
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_;
  bool big_;
  const PlyElement* element_ = nullptr;
  std::int64_t index_ = 0;
};

/// One for each property of an element of vertices or faces, without a name where it is not wanted.
std::vector<MeshProperty> list_properties(const PlyElement& element) {
  std::vector<MeshProperty> found;
  const bool vertices = element.name == "vertex";
  if (!vertices && element.name != "face") return found;
  const int corners = vertices ? -1 : find_corner_list(element);
  for (const PlyProperty& property : element.properties) {
    const bool coordinate = vertices && (property.name == "x" || property.name == "y" || property.name == "z");
    const bool wanted = !coordinate && std::ssize(found) != corners;
    found.push_back({wanted ? property.name : "", property.type, vertices, {}, property.count_type, {}});
    if (property.count_type) found.back().first_value.push_back(0);
  }
  return found;
}

template <class Source>
class BodyParser {
 public:
  BodyParser(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : header_(header), source_(bytes, name, header), name_(name) {}

  /// The numbers of one property of the element of this name.
  std::vector<double> parse_property(const PlyElement& wanted, std::size_t index) {
    std::vector<double> values;
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.properties.empty()) continue;
      for (std::int64_t i = 0; i < element.count; ++i) {
        read_element(element, i, [&](int p) {
          if (&element != &wanted || p != static_cast<int>(index)) return false;
          values.push_back(source_.read(element.properties[index].type, element.properties[index]));
          return true;
        });
      }
    }
    return values;
  }

  std::vector<MeshProperty> parse_properties() {
    std::vector<MeshProperty> all;
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.properties.empty()) continue;
      std::vector<MeshProperty> found = list_properties(element);
      for (std::int64_t i = 0; i < element.count; ++i) {
        read_element(element, i, [&](int p) {
          MeshProperty* const property = found.empty() ? nullptr : &found[p];
          if (property == nullptr || property->name.empty()) return false;
          read_values(*property, element.properties[p], i);
          return true;
        });
      }
      std::erase_if(found, [](const MeshProperty& property) { return property.name.empty(); });
      std::move(found.begin(), found.end(), std::back_inserter(all));
    }
    return all;
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
    if (least == 0 || static_cast<std::uint64_t>(element.count) <= source_.remaining() / least) return;
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

  // Reads element i. take(p) reads property p and returns true; where it returns false, the property is skipped.
  template <class Take>
  void read_element(const PlyElement& element, std::int64_t i, Take take) {
    source_.begin_element(element, i);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (take(static_cast<int>(p))) continue;
      const std::int64_t count = property.count_type ? read_count(property, i) : 1;
      source_.skip(property.type, count, property);
    }
    source_.end_element(element, i);
  }

  std::int64_t read_count(const PlyProperty& property, std::int64_t i) {
    const double count = source_.read(*property.count_type, property);
    if (!(count >= 0) || count != std::floor(count) || count > static_cast<double>(source_.most_entries())) {
      refuse(ErrorCode::unreadable_input,
             fmt::format("the list '{}' announces {} {}, but the file has room for {}", property.name, count,
                         count == 1 ? "entry" : "entries", source_.most_entries()),
             i);
    }
    return static_cast<std::int64_t>(count);
  }

  void read_vertices(const PlyElement& element) {
    check_counts(static_cast<std::uint64_t>(element.count), 0, name_);
    const std::array<int, 3> xyz = {element.find("x"), element.find("y"), element.find("z")};
    soup_.positions.reserve(static_cast<std::size_t>(element.count));
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
    check_counts(0, static_cast<std::uint64_t>(element.count), name_);
    const int list = find_corner_list(element);
    const PlyProperty& property = element.properties[list];
    soup_.corners.reserve(3 * static_cast<std::size_t>(element.count));
    soup_.first_corner.reserve(static_cast<std::size_t>(element.count) + 1);
    for (std::int64_t i = 0; i < element.count; ++i) {
      read_element(element, i, [&](int p) {
        if (p != list) return false;
        const std::int64_t size = read_count(property, i);
        for (std::int64_t c = 0; c < size; ++c) soup_.corners.push_back(read_index(property, i));
        return true;
      });
      soup_.close_polygon();
    }
  }

  // Strips of triangles: each corner makes a triangle with the two before it, every second one turned round. The index
  // -1 begins another strip. A triangle with a repeated corner only leads from one strip to the next.
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

  std::int32_t read_index(const PlyProperty& property, std::int64_t face) {
    return require_index(source_.read(property.type, property), face, "face");
  }

  std::int32_t require_index(double index, std::int64_t face, const char* kind) {
    if (!(index >= 0) || index >= static_cast<double>(vertices_) || index != std::floor(index)) {
      refuse(ErrorCode::unreadable_input,
             fmt::format("{} {} refers to vertex {}, and there are {}", kind, face, index, vertices_), face);
    }
    return static_cast<std::int32_t>(index);
  }

  const PlyHeader& header_;
  Source source_;
  std::string_view name_;
  PolygonSoup soup_;
  std::int64_t vertices_ = 0;
};

/// None where a list has numbers, but not two for each corner.
std::optional<CornerTexture> make_texture(const MeshProperty& list, PolygonSoup soup) {
  if (list.element_count() != soup.polygon_count()) return std::nullopt;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  CornerTexture texture;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const std::size_t corners = soup.polygon(p).size(), first = list.first_value[p];
    const std::size_t numbers = list.first_value[p + 1] - first;
    if (numbers != 0 && numbers != 2 * corners) return std::nullopt;
    for (std::size_t i = 0; i < corners; ++i) {
      numbers == 0 ? texture.coordinates.push_back({kNone, kNone})
                   : texture.coordinates.push_back({list.values[first + 2 * i], list.values[first + 2 * i + 1]});
    }
  }
  texture.corners = std::move(soup.corners);
  texture.first_corner = std::move(soup.first_corner);
  return texture;
}

}  // namespace

std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property,
                                               std::string_view name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  for (const PlyElement& element : header.elements) {
    const int index = element.name == "vertex" || element.name == "face" ? element.find(property) : -1;
    if (index < 0 || element.properties[index].count_type) continue;
    const auto read = [&](auto parser) { return parser.parse_property(element, static_cast<std::size_t>(index)); };
    SoupProperty found{element.name == "vertex", {}};
    found.values = header.encoding == PlyEncoding::ascii ? read(BodyParser<AsciiSource>(bytes, name, header))
                                                         : read(BodyParser<BinarySource>(bytes, name, header));
    return found;
  }
  return std::nullopt;
}

MeshAttributes parse_ply_attributes(std::string_view bytes, std::string_view name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  MeshAttributes found;
  found.properties = header.encoding == PlyEncoding::ascii
                         ? BodyParser<AsciiSource>(bytes, name, header).parse_properties()
                         : BodyParser<BinarySource>(bytes, name, header).parse_properties();
  const auto list = std::find_if(found.properties.begin(), found.properties.end(), [](const MeshProperty& property) {
    return !property.of_vertices && property.count_type && property.name == "texcoord";
  });
  if (list == found.properties.end()) return found;
  found.texture = make_texture(*list, parse_ply(bytes, name));
  if (found.texture) found.properties.erase(list);
  return found;
}

PolygonSoup parse_ply(std::string_view bytes, std::string_view name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  if (header.encoding == PlyEncoding::ascii) return BodyParser<AsciiSource>(bytes, name, header).parse();
  return BodyParser<BinarySource>(bytes, name, header).parse();
}

}  // namespace gvd
