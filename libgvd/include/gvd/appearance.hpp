#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace gvd {

/// Texture coordinates of a corner: u to the right and v upwards, as in OBJ and PLY. In glTF, v runs downwards.
using Uv = std::array<double, 2>;

/// The texture coordinates of a corner that has none.
inline constexpr Uv kNoTexture{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
/// Whether a corner has texture coordinates. A polygon with a corner that has none is written without any.
inline bool is_finite(const Uv& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); }

/// The name in OBJ of no material, as Blender writes it: a face can't take back the one of the face before it.
inline constexpr std::string_view kNoMaterial = "(null)";

/// What Appearance::unread calls these, wherever a reader finds them.
inline constexpr const char *kUnreadTexture = "texture coordinates", *kUnreadImages = "texture images";

/// How polygons or faces are painted, as an OBJ says by `vt`, `mtllib` and `usemtl`. What there is none of is empty.
struct Appearance {
  std::vector<Uv> texture;                  ///< per corner, of all polygons in order; not finite where it has none
  std::vector<std::int32_t> material;       ///< per polygon: index into `materials`; -1 where it has none
  std::vector<std::string> materials;       ///< their names
  std::vector<std::string> material_files;  ///< that describe the materials, as the input names them
  std::vector<std::string> unread;  ///< what else the input has, for messages with placeholders: "texture images"

  /// Whether there is nothing to carry over; `unread` and the files do not count.
  bool empty() const { return texture.empty() && material.empty(); }
};

}  // namespace gvd
