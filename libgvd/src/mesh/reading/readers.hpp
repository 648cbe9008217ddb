#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "gvd/mesh_property.hpp"
#include "gvd/read_soup.hpp"

// The readers of the four formats. `bytes` is a whole file and `name` stands for it in messages. Errors, properties and
// cost are those of `parse_soup`.
namespace gvd {

/// Wavefront OBJ: the statements `v` and `f`; all others are skipped.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

/// The texture of an OBJ, from `v`, `vt` and `f`; none where no corner refers to a `vt` of the file.
std::optional<CornerTexture> parse_obj_texture(std::string_view bytes, std::string_view name);

/// PLY, text and binary: the elements `vertex` and `face`; other elements and properties are skipped.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

/// One property of the element `vertex`, or else of `face`, that is a number: none where there is no such property.
std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property,
                                               std::string_view name);

/// The properties and the texture of a PLY, as read_mesh_attributes returns them.
MeshAttributes parse_ply_attributes(std::string_view bytes, std::string_view name);

/// Geomview's OFF in text, with or without colours, normals and texture coordinates, which are skipped. Each vertex and
/// each face begins a line.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

/// Whether a word is the keyword of an OFF file: OFF, COFF, NOFF, STCNOFF, 4OFF, nOFF and so on.
bool is_off_keyword(std::string_view word);

/// STL, binary and text: triangles with vertices of their own.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// Whether the file has exactly the length that the triangle count in its header asks for.
bool is_binary_stl(std::string_view bytes);

inline constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} where there are more vertices or polygons than 32-bit ids can count.
void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name);

}  // namespace gvd
