#include "mesh/reading/read_stl.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "base/printable.hpp"
#include "gvd/counted.hpp"
#include "gvd/error.hpp"
#include "mesh/reading/check_counts.hpp"
#include "mesh/reading/read_text.hpp"

namespace gvd {
namespace {

constexpr std::size_t kStlHeader = 84;    // 80 bytes of text and the triangle count
constexpr std::size_t kStlTriangle = 50;  // a normal, three vertices, two bytes of attributes

/// The count in a binary STL's header. The file must hold kStlHeader bytes.
std::uint32_t stl_triangle_count(std::string_view bytes) {
  std::uint32_t count = 0;
  for (int i = 3; i >= 0; --i) count = count << 8 | static_cast<unsigned char>(bytes[80 + i]);
  return count;
}

float little_endian_float(const char* bytes) {
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  return std::bit_cast<float>(bits);
}

Vec3 binary_position(std::string_view bytes, std::size_t offset, std::string_view name, std::int64_t triangle) {
  const char* at = bytes.data() + offset;
  const Vec3 p(little_endian_float(at), little_endian_float(at + 4), little_endian_float(at + 8));
  if (!p.allFinite()) {
    throw Error(ErrorCode::precondition,
                fmt::format("{}: byte {}: a coordinate of triangle {} is not a finite number", name, offset, triangle),
                triangle);
  }
  return p;
}

/// Throws Error{unreadable_input} where the file is shorter than a binary STL with the count of its header.
void check_binary_length(std::string_view bytes, std::string_view name) {
  if (bytes.size() < kStlHeader) {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: {} too few for an STL file, and it does not start with 'solid'", name,
                            counted(std::ssize(bytes), "byte is", "bytes are")));
  }
  const std::uint64_t count = stl_triangle_count(bytes);
  const std::uint64_t wanted = kStlHeader + kStlTriangle * count;
  if (bytes.size() < wanted) {
    throw Error(
        ErrorCode::unreadable_input,
        fmt::format("{}: the file does not start with 'solid', and as a binary STL of {} it should have {} "
                    "bytes, not {}",
                    name, counted(static_cast<std::int64_t>(count), "triangle", "triangles"), wanted, bytes.size()),
        static_cast<std::int64_t>((bytes.size() - kStlHeader) / kStlTriangle));
  }
}

PolygonSoup parse_binary(std::string_view bytes, std::string_view name) {
  check_binary_length(bytes, name);
  const std::uint64_t count = stl_triangle_count(bytes);
  const std::uint64_t wanted = kStlHeader + kStlTriangle * count;
  check_counts(3 * count, count, name);
  PolygonSoup soup;
  soup.unwelded = true;
  soup.positions.reserve(3 * count);
  soup.corners.reserve(3 * count);
  soup.first_corner.reserve(count + 1);
  for (std::uint64_t t = 0; t < count; ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t offset = kStlHeader + kStlTriangle * t + 12 * (corner + 1);
      soup.corners.push_back(static_cast<std::int32_t>(soup.positions.size()));
      soup.positions.push_back(binary_position(bytes, offset, name, static_cast<std::int64_t>(t)));
    }
    soup.close_polygon();
  }
  if (bytes.size() > wanted) {
    soup.notes.push_back(counted(static_cast<std::int64_t>(bytes.size() - wanted),
                                 "byte after the last triangle is left out",
                                 "bytes after the last triangle are left out"));
  }
  return soup;
}

bool same_word(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (static_cast<char>(word[i] | 0x20) != lower[i]) return false;
  }
  return true;
}

class TextStlParser {
 public:
  TextStlParser(std::string_view bytes, std::string_view name) : text_(bytes, name, false) { soup_.unwelded = true; }

  // The lines of each solid: solid (facet (outer loop, three times vertex, endloop) endfacet)... endsolid.
  PolygonSoup parse() {
    while (text_.next_content_line()) {
      const std::string_view word = text_.token();
      if (same_word(word, "solid")) {
        open(in_solid_, true, "solid");
      } else if (same_word(word, "endsolid")) {
        close(in_solid_, !in_facet_, "endsolid");
      } else if (same_word(word, "facet")) {
        open(in_facet_, in_solid_, "facet");
      } else if (same_word(word, "outer")) {
        open(in_loop_, in_facet_, "outer loop");
      } else if (same_word(word, "vertex")) {
        add_vertex();
      } else if (same_word(word, "endloop")) {
        close_loop();
      } else if (same_word(word, "endfacet")) {
        close(in_facet_, !in_loop_, "endfacet");
      } else {
        text_.refuse(fmt::format("{} is no statement of a text STL", quoted(word)));
      }
    }
    if (in_solid_) text_.refuse_end("and endsolid is missing");
    return std::move(soup_);
  }

 private:
  void open(bool& inside, bool allowed, std::string_view what) {
    if (inside || !allowed) text_.refuse(fmt::format("'{}' is out of place", what));
    inside = true;
  }

  void close(bool& inside, bool allowed, std::string_view what) {
    if (!inside || !allowed) text_.refuse(fmt::format("'{}' is out of place", what));
    inside = false;
  }

  void add_vertex() {
    if (!in_loop_) text_.refuse("'vertex' is out of place");
    const auto count = static_cast<std::int64_t>(soup_.positions.size());
    check_counts(static_cast<std::uint64_t>(count) + 1, 0, "the file");
    soup_.positions.push_back(text_.position(count));
    soup_.corners.push_back(static_cast<std::int32_t>(count));
  }

  void close_loop() {
    close(in_loop_, true, "endloop");
    const std::size_t size = soup_.corners.size() - soup_.first_corner.back();
    const auto facet = static_cast<std::int64_t>(soup_.polygon_count());
    if (size != 3)
      text_.refuse(fmt::format("facet {} has {}, and should have 3", facet, counted(size, "vertex", "vertices")),
                   facet);
    soup_.close_polygon();
  }

  TextReader text_;
  PolygonSoup soup_;
  bool in_solid_ = false;
  bool in_facet_ = false;
  bool in_loop_ = false;
};

// Some binary files start with "solid" too, but their first 512 bytes contain a zero byte, which no text does.
bool is_text(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || !same_word(bytes.substr(begin, 5), "solid")) return false;
  return bytes.substr(0, 512).find('\0') == std::string_view::npos;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeader) return false;
  const std::uint64_t count = stl_triangle_count(bytes);
  return count > 0 && bytes.size() == kStlHeader + kStlTriangle * count;
}

PolygonSoup parse_stl(std::string_view bytes, std::string_view name) {
  if (is_binary_stl(bytes) || !is_text(bytes)) return parse_binary(bytes, name);
  return TextStlParser(bytes, name).parse();
}

}  // namespace gvd
