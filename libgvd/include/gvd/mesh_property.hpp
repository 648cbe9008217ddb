#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/read_soup.hpp"

namespace gvd {

/// How a file stores a number.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline bool is_integer(NumberType type) { return type != NumberType::float32 && type != NumberType::float64; }

/// A number for each vertex, or for each polygon, of a file or a mesh, such as a colour's red; or a list of numbers.
struct MeshProperty {
  std::string name;
  NumberType type = NumberType::float64;
  bool of_vertices = true;                 ///< otherwise of polygons
  std::vector<double> values;              ///< a double holds those of all types
  std::optional<NumberType> count_type{};  ///< of lists: how their lengths are stored
  std::vector<std::size_t> first_value{};  ///< of lists: per element, and the number of values at the end

  /// Vertices or polygons that have a value or a list.
  std::size_t element_count() const {
    return !count_type ? values.size() : first_value.empty() ? 0 : first_value.size() - 1;
  }
};

/// Texture coordinates of the corners of polygons: a vertex may have others in each of its polygons.
struct CornerTexture {
  std::vector<std::int32_t> corners;               ///< of all polygons, one after the other: vertices
  std::vector<std::size_t> first_corner;           ///< per polygon, and the number of corners at the end
  std::vector<std::array<double, 2>> coordinates;  ///< per corner: u and v; not finite where it has none
};

/// The contents of a file besides positions and polygons.
struct MeshAttributes {
  std::vector<MeshProperty> properties;
  std::optional<CornerTexture> texture;
};

/// PLY: the properties of vertices but for their coordinates, and of polygons, in the file's order; a list `texcoord`
/// of two numbers for each corner is the texture. Those of strips of triangles are left out. OBJ: the texture, from
/// `vt` and `f`. Nothing of other formats, also where they have data of points and cells.
/// `format` overrides the detection.
/// Throws Error{unreadable_input} where the file can't be read. Cost: O(bytes).
MeshAttributes read_mesh_attributes(const std::filesystem::path& path, std::optional<MeshFormat> format = {});

/// `read_mesh_attributes` from bytes in memory; `name` stands for the file in messages.
MeshAttributes parse_mesh_attributes(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace gvd
