#pragma once

#include <filesystem>
#include <vector>

namespace gvd {

/// The files beside a glTF that it refers to, buffers and images, as paths from the folder of the mesh; none for a file
/// of another format. Addresses that `read_soup` refuses, such as those of the web, are left out.
/// Throws Error{unreadable_input} where the file or its description can't be read. Cost: O(bytes).
std::vector<std::filesystem::path> list_gltf_files(const std::filesystem::path& mesh);

}  // namespace gvd
