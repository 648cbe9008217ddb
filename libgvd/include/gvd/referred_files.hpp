#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/read_soup.hpp"

namespace gvd {

/// Lists the files that a mesh refers to, as paths relative to its folder: buffers and images of a glTF, and material
/// files of an OBJ. A file of another format refers to none. Addresses that `read_soup` refuses, such as those of the
/// web, are left out. `format` overrides the detection, as for `read_soup`.
/// Throws Error{unreadable_input} if the file, or a glTF's description, can't be read. Cost: O(bytes) for a glTF, an
/// OBJ and a compressed file, otherwise O(1).
std::vector<std::filesystem::path> list_referred_files(const std::filesystem::path& mesh,
                                                       std::optional<MeshFormat> format = {});

/// Lists the files that the statements `mtllib` of an OBJ name, as paths relative to the folder of the mesh.
/// `statements` are the texts after the keyword, as in Appearance::material_files. Most programs write one file per
/// statement, whose name may contain blanks. If there is no such file, the words of the statement are taken as names of
/// files, too, as in the format's manual.
std::vector<std::filesystem::path> list_material_files(const std::filesystem::path& mesh,
                                                       const std::vector<std::string>& statements);

}  // namespace gvd
