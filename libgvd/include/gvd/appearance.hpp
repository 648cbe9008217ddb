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
/// Whether a corner has texture coordinates. If one corner of a polygon has none, writers leave out those of the whole
/// polygon.
inline bool is_finite(const Uv& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); }

/// The material name that stands for "no material" in OBJ, as Blender writes it. It is needed because a face in OBJ
/// keeps the material of the face before it until another one is named.
inline constexpr std::string_view kNoMaterial = "(null)";

/// The names in Appearance::unread for textures that a reader leaves out.
inline constexpr const char *kUnreadTexture = "texture coordinates", *kUnreadImages = "texture images";

/// How polygons or faces are painted: texture coordinates and materials, as OBJ has them in `vt`, `mtllib` and
/// `usemtl`. A list is empty if the input has nothing of its kind.
struct Appearance {
  std::vector<Uv> texture;                  ///< one per corner, polygon by polygon; not finite for a corner without
  std::vector<std::int32_t> material;       ///< per polygon: index into `materials`; -1 for none
  std::vector<std::string> materials;       ///< names of the materials
  std::vector<std::string> material_files;  ///< files that describe the materials, as the input names them
  std::vector<std::string> unread;  ///< what was left out, as words for messages with placeholders: "texture images"

  /// Whether there is nothing to carry over; `unread` and the files do not count.
  bool empty() const { return texture.empty() && material.empty(); }
};

}  // namespace gvd
