#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/read_soup.hpp"

namespace gvd {

/// The files beside a mesh that it refers to, as paths from the folder of the mesh: buffers and images of a glTF, and
/// the descriptions of materials of an OBJ. None for a file of another format. Addresses that `read_soup` refuses, such
/// as those of the web, are left out. `format` overrides the detection, as for `read_soup`.
/// Throws Error{unreadable_input} where the file, or a glTF's description, can't be read. Cost: O(bytes) for a glTF, an
/// OBJ and a packed file, otherwise O(1).
std::vector<std::filesystem::path> list_referred_files(const std::filesystem::path& mesh,
                                                       std::optional<MeshFormat> format = {});

/// The files that statements `mtllib` of an OBJ name, as paths from the folder of the mesh. `statements`: what follows
/// the keyword, as in Appearance::material_files. It is one file, whose name may have blanks, as most programs write
/// it. Where no such file is there, its words are files, too, as the format's manual has it.
std::vector<std::filesystem::path> list_material_files(const std::filesystem::path& mesh,
                                                       const std::vector<std::string>& statements);

}  // namespace gvd
