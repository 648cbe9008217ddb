#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace gvd
