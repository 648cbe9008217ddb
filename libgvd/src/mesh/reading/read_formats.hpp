#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "gvd/soup.hpp"

namespace gvd {

// One parser a format; errors and properties as `parse_soup` says.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);
PolygonSoup parse_off(std::string_view bytes, std::string_view name);
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// OFF, COFF, NOFF, STCNOFF, 4OFF, nOFF...
bool is_off_keyword(std::string_view word);

/// Whether the length of the file is what the triangle count in its header asks for.
bool is_binary_stl(std::string_view bytes);

inline constexpr std::size_t kStlHeader = 84;    ///< 80 bytes of text and the triangle count
inline constexpr std::size_t kStlTriangle = 50;  ///< a normal, three vertices, two bytes of attributes

/// The count in a binary STL's header. The file must hold kStlHeader bytes.
inline std::uint32_t stl_triangle_count(std::string_view bytes) {
  std::uint32_t count = 0;
  for (int i = 3; i >= 0; --i) count = count << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(80 + i)]);
  return count;
}

inline constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} where there are more vertices or polygons than 32-bit ids can count.
void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name);

/// Ends the polygon whose corners were just added.
inline void close_polygon(PolygonSoup& soup) { soup.first_corner.push_back(soup.corners.size()); }

}  // namespace gvd
