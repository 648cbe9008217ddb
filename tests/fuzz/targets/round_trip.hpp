#pragma once

#include <cstddef>
#include <cstdint>

#include "gvd/io/mesh_writer.hpp"
#include "gvd/read_soup.hpp"

namespace gvd::fuzz {

/// Reads bytes as a mesh file, repairs the soup, and writes and reads the mesh again. Fails unless
/// - the reader gives a soup whose indices and coordinates are sound, or a proper Error;
/// - `build_mesh` gives a mesh whose edges have one or two faces and whose vertices have one fan, or a proper Error;
/// - the written mesh reads back with the same bits and without a defect. STL is left out there: it has no vertices.
void check_reading(const std::uint8_t* data, std::size_t size, MeshFormat format);

}  // namespace gvd::fuzz
