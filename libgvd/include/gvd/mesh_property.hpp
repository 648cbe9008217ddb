#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gvd {

/// How a file stores a number.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline bool is_integer(NumberType type) { return type != NumberType::float32 && type != NumberType::float64; }

/// A number for each vertex, or for each polygon, of a file or a mesh, such as a colour's red.
struct MeshProperty {
  std::string name;
  NumberType type = NumberType::float64;
  bool of_vertices = true;     ///< otherwise of polygons
  std::vector<double> values;  ///< a double holds those of all types
};

/// The properties of a PLY file's vertices but for their coordinates, and of its polygons, in the file's order. Lists
/// are left out; so are the properties of strips of triangles. None where the file is no PLY file.
/// Throws Error{unreadable_input} where it can't be read. Cost: O(bytes).
std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path);

}  // namespace gvd
