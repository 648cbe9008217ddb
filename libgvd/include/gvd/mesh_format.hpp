#pragma once

#include <optional>
#include <string_view>

namespace gvd {

enum class MeshFormat { obj, ply, off, stl };

/// "obj", "ply", "off" or "stl".
std::string_view name_of(MeshFormat format);

/// The format of a file name's extension or of a bare name such as "ply", upper or lower case; none where it is
/// another.
std::optional<MeshFormat> format_from_extension(std::string_view name);

/// The format of a file. Its content decides where it can't be mistaken (the first line of a PLY or OFF, an STL's
/// length or first word); otherwise the extension of `name` does; otherwise the first statements of an OBJ.
/// None where nothing fits. Cost: O(1), but for leading comments.
std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name);

}  // namespace gvd
