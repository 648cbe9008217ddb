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

/// A property of all vertices, or of all polygons, of a file or a mesh: one number each, such as the red of a colour,
/// or a list of numbers each.
struct MeshProperty {
  std::string name;
  NumberType type = NumberType::float64;
  bool of_vertices = true;                 ///< if false, of polygons
  std::vector<double> values;              ///< a double can hold the values of all types
  std::optional<NumberType> count_type{};  ///< only for lists: how their lengths are stored
  std::vector<std::size_t> first_value{};  ///< where each list begins in `values`, then the size of `values`

  /// The number of vertices or polygons that have a value or a list.
  std::size_t element_count() const {
    return !count_type ? values.size() : first_value.empty() ? 0 : first_value.size() - 1;
  }
};

}  // namespace gvd
