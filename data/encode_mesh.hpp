#pragma once

#include <string>

#include "gvd/mesh.hpp"

namespace gvd::data {

// The bytes of a file with this mesh. Coordinates are rounded to six decimals first. So the last bits of a sine, which
// differ from one mathematical library to the next, do not reach the file.

std::string encode_obj(const Mesh& mesh, const std::string& comment);
std::string encode_off(const Mesh& mesh, const std::string& comment);
std::string encode_binary_ply(const Mesh& mesh, const std::string& comment);  ///< little endian, float coordinates
std::string encode_binary_stl(const Mesh& mesh);                              ///< every face with corners of its own

}  // namespace gvd::data
