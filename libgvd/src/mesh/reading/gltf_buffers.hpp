#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/reading/unpack.hpp"

namespace gvd {

/// Reads the bytes of a glTF buffer that has an address (`uri`), from a Base64 data URI or from a file in `folder`.
///
/// Without `folder`, only data URIs are read. A file must lie in the folder or below it, after percent-decoding and
/// after following symbolic links, so that a mesh can't make a program read other files. Absolute paths, "..", schemes
/// such as http: and file:, and backslashes are refused.
/// The size of a file is added to `limit`. Throws Error{unreadable_input} that begins with `name` and names the buffer
/// `b`. Cost: O(bytes).
std::string read_gltf_buffer(std::string_view uri, std::size_t b, const std::optional<std::filesystem::path>& folder,
                             ExpansionLimit& limit, std::string_view name);

/// The path of a glTF's address, relative to the folder of the mesh; nothing if the address is a data URI or leads
/// elsewhere.
std::optional<std::filesystem::path> gltf_file(std::string_view uri);

}  // namespace gvd
