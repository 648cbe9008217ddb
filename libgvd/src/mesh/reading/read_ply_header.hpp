#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/mesh_property.hpp"

namespace gvd {

enum class PlyEncoding { ascii, little_endian, big_endian };

/// Size of a number in a binary file, in bytes.
inline std::size_t size_of(NumberType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

struct PlyProperty {
  std::string name;  ///< made printable and short, for messages; names with a meaning, such as "x", do not change
  NumberType type{};
  std::optional<NumberType> count_type;  ///< only for a list: the type of its length
};

struct PlyElement {
  std::string name;  ///< made printable and short
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Index of the property with this name; -1 if there is none.
  int find(std::string_view property) const;
};

/// Index of the list with a face's or strip's corners; -1 if there is none.
inline int find_corner_list(const PlyElement& element) {
  return std::max(element.find("vertex_indices"), element.find("vertex_index"));
}

struct PlyHeader {
  PlyEncoding encoding{};
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;    ///< length of the header, where the data begin
  std::int64_t lines = 0;   ///< number of lines of the header
  bool has_images = false;  ///< a comment names the image of a texture, as MeshLab writes it
};

/// The part of a PLY to read.
enum class PlyContent { surface, lines, points };

/// Reads the header of a PLY file. Throws Error{unreadable_input} with the line if it is malformed. The header must
/// have an element `vertex` with x, y and z. A surface also needs `face` or `tristrips` with a list `vertex_indices` or
/// `vertex_index`, and lines need `edge` with vertex1 and vertex2.
PlyHeader parse_ply_header(std::string_view bytes, std::string_view name, PlyContent content = PlyContent::surface);

}  // namespace gvd
