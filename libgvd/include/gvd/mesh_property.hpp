#pragma once

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

/// PLY: the properties of vertices but for their coordinates, and of polygons, in the file's order. Those of a texture,
/// which `read_soup` reads, and of strips of triangles are left out. OBJ: the colours of vertices as `red`, `green`,
/// `blue` and, where a vertex has one, `alpha`, of 8 bits. Nothing of other formats, also where they have data of
/// points and cells. `format` overrides the detection.
/// Throws Error{unreadable_input} where the file can't be read. Cost: O(bytes).
std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path,
                                               std::optional<MeshFormat> format = {});

/// `read_mesh_properties` from bytes in memory; `name` stands for the file in messages.
std::vector<MeshProperty> parse_mesh_properties(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace gvd
