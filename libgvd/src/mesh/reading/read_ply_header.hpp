#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gvd {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// In bytes.
std::size_t size_of(PlyType type);
inline bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

struct PlyProperty {
  std::string name;
  PlyType type{};
  std::optional<PlyType> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Where the property of this name stands; -1 where there is none.
  int find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding{};
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;   ///< where the data begin
  std::int64_t lines = 0;  ///< of the header
};

/// Throws Error{unreadable_input} with the line where this is no PLY header, where it has no `vertex` element with x, y
/// and z, or no `face` element with a list `vertex_indices` or `vertex_index`.
PlyHeader parse_ply_header(std::string_view bytes, std::string_view name);

}  // namespace gvd
