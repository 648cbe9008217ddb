// Reads STL, binary and text: triangles that share no vertices.
//
// A file is binary if its length is exactly the length that follows from its triangle count, whatever its first word,
// because many binary files begin with "solid". Otherwise a file is text if it begins with "solid" and has no zero byte
// near its start.
// Source: 3D Systems' StereoLithography Interface Specification. In a text, solids, facets and loops are nested, and
// the level alone decides which statement may come next. Normals are skipped, because they follow from the corners.
// Invariant: the soup is marked as unwelded, so that the repair joins vertices at the same position.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

// 64 bits, because the length of a file with 2^32 - 1 triangles needs 38 bits, and WebAssembly's sizes have 32.
constexpr std::uint64_t kStlHeader = 84;    // 80 bytes of text and the triangle count
constexpr std::uint64_t kStlTriangle = 50;  // a normal, three vertices, two bytes of attributes

/// Reads four bytes as a little-endian number.
std::uint32_t little_endian(const char* bytes) {
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8 | std::uint8_t(bytes[i]);
  return bits;
}

/// The triangle count in a binary STL's header. The file must have at least kStlHeader bytes.
std::uint32_t stl_triangle_count(std::string_view bytes) { return little_endian(bytes.data() + 80); }

std::uint64_t stl_length(std::string_view bytes) { return kStlHeader + kStlTriangle * stl_triangle_count(bytes); }

Vec3 binary_position(std::string_view bytes, std::size_t offset, std::string_view name, std::int64_t triangle) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = std::bit_cast<float>(little_endian(bytes.data() + offset + 4 * i));
  if (!p.allFinite()) {
    throw Error(ErrorCode::precondition,
                fmt::format("{}: byte {}: a coordinate of triangle {} is not a finite number", name, offset, triangle),
                triangle);
  }
  return p;
}

/// Throws Error{unreadable_input} if the file is shorter than the triangle count in its header requires.
void check_binary_length(std::string_view bytes, std::string_view name) {
  if (bytes.size() < kStlHeader) {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: {} too few for an STL file, and it does not start with 'solid'", name,
                            counted(std::ssize(bytes), "byte is", "bytes are")));
  }
  const std::uint64_t count = stl_triangle_count(bytes);
  const std::uint64_t wanted = stl_length(bytes);
  if (count == 0) {
    const std::uint64_t left = bytes.size() - kStlHeader;
    throw Error(
        ErrorCode::unreadable_input,
        fmt::format("{}: the header of the STL says that there are 0 triangles, and {}; write the file again", name,
                    left == 0
                        ? "none follows"
                        : fmt::format("{}, room for {}", counted(std::int64_t(left), "byte follows", "bytes follow"),
                                      counted(std::int64_t(left / kStlTriangle), "triangle", "triangles"))));
  }
  if (bytes.size() < wanted) {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: the file does not start with 'solid', and as a binary STL of {} it should have {} "
                            "bytes, not {}",
                            name, counted(count, "triangle", "triangles"), wanted, bytes.size()),
                (bytes.size() - kStlHeader) / kStlTriangle);
  }
}

PolygonSoup parse_binary(std::string_view bytes, std::string_view name) {
  check_binary_length(bytes, name);
  const std::uint64_t count = stl_triangle_count(bytes);
  const std::uint64_t wanted = stl_length(bytes);
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
      soup.positions.push_back(binary_position(bytes, offset, name, t));
    }
    soup.close_polygon();
  }
  if (bytes.size() > wanted) {
    soup.notes.push_back(counted(bytes.size() - wanted, "byte after the last triangle is left out",
                                 "bytes after the last triangle are left out"));
  }
  return soup;
}

/// Whether a word equals `lower`, ignoring case.
bool same_word(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  return std::equal(word.begin(), word.end(), lower.begin(), [](char c, char l) { return (c | 0x20) == l; });
}

/// A statement that opens or closes a level of a text STL.
struct StlStatement {
  std::string_view word, name;
  int from, to;  ///< levels: 0 outside, 1 in a solid, 2 in a facet, 3 in its loop
};
constexpr std::array<StlStatement, 6> kStlStatements = {{{"solid", "solid", 0, 1},
                                                         {"facet", "facet", 1, 2},
                                                         {"outer", "outer loop", 2, 3},
                                                         {"endloop", "endloop", 3, 2},
                                                         {"endfacet", "endfacet", 2, 1},
                                                         {"endsolid", "endsolid", 1, 0}}};

/// Reads each solid: solid (facet (outer loop, three times vertex, endloop) endfacet)... endsolid.
PolygonSoup parse_text_stl(std::string_view bytes, std::string_view name) {
  TextReader text(bytes, name, false);
  PolygonSoup soup;
  soup.unwelded = true;
  int level = 0;
  while (text.next_content_line()) {
    const std::string_view word = text.token();
    if (same_word(word, "vertex")) {
      if (level != 3) text.refuse("'vertex' is out of place");
      const std::size_t count = soup.positions.size();
      check_counts(count + 1, 0, "the file");
      soup.positions.push_back(text.position(count));
      soup.corners.push_back(std::int32_t(count));
      continue;
    }
    const auto is_named = [&](const StlStatement& s) { return same_word(word, s.word); };
    const auto statement = std::ranges::find_if(kStlStatements, is_named);
    if (statement == kStlStatements.end())
      text.refuse(fmt::format("{} is not a statement of a text STL", quoted(word)));
    if (level != statement->from) text.refuse(fmt::format("'{}' is out of place", statement->name));
    level = statement->to;
    if (statement->from != 3) continue;
    const std::size_t size = soup.corners.size() - soup.first_corner.back(), facet = soup.polygon_count();
    if (size != 3) {
      text.refuse(fmt::format("facet {} has {}, and should have 3", facet, counted(size, "vertex", "vertices")), facet);
    }
    soup.close_polygon();
  }
  if (level > 0) text.refuse_end("and endsolid is missing");
  return soup;
}

/// Whether a file is text. Some binary files also start with "solid", but unlike text they have a zero byte among their
/// first 512 bytes.
bool is_text(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || !same_word(bytes.substr(begin, 5), "solid")) return false;
  return bytes.substr(0, 512).find('\0') == std::string_view::npos;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeader) return false;
  return stl_triangle_count(bytes) > 0 && bytes.size() == stl_length(bytes);
}

PolygonSoup parse_stl(std::string_view bytes, std::string_view name) {
  if (is_binary_stl(bytes) || !is_text(bytes)) return parse_binary(bytes, name);
  return parse_text_stl(bytes, name);
}

}  // namespace gvd
