#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/reading/unpack.hpp"

namespace gvd {

/// The bytes of a glTF buffer that has an address (`uri`): those of a Base64 data URI, or of a file in `folder`.
///
/// Where `folder` is empty, there are no other files, and only data URIs are read. A file lies in the folder or in one
/// below it, after percent-decoding, and after following symbolic links: a mesh can't make a program read what lies
/// elsewhere. Absolute paths, "..", schemes such as http: and file:, and backslashes are refused.
/// `limit` learns of the size of a file. Throws Error{unreadable_input} that begins with `name` and names the buffer
/// `b`. Cost: O(bytes).
std::string read_gltf_buffer(std::string_view uri, std::size_t b, const std::optional<std::filesystem::path>& folder,
                             ExpansionLimit& limit, std::string_view name);

/// The path from the folder of the mesh that an address of a glTF stands for; nothing where it is a data URI or leads
/// elsewhere.
std::optional<std::filesystem::path> gltf_file(std::string_view uri);

}  // namespace gvd
