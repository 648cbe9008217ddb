#pragma once

#include <optional>
#include <string_view>

namespace gvd {

enum class MeshFormat { obj, ply, off, stl };

/// "obj", "ply", "off" or "stl".
std::string_view name_of(MeshFormat format);

/// The format that a file name's extension, or a bare name such as "ply", stands for, in upper or lower case; nothing
/// for any other name.
std::optional<MeshFormat> format_from_extension(std::string_view name);

/// The format of a file. The content decides first: the first line of a PLY or OFF, the length or the first word of an
/// STL, the first statement of an OBJ. Otherwise the extension of `name` decides. Nothing where neither is known.
/// Cost: O(1), and O(length) of leading comments.
std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name);

}  // namespace gvd
