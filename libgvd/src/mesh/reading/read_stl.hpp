#pragma once

#include <string_view>

#include "gvd/read_soup.hpp"

namespace gvd {

/// STL, binary and text: triangles with vertices of their own. Errors, properties and cost as of `parse_soup`.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// Whether the file has exactly the length that the triangle count in its header asks for.
bool is_binary_stl(std::string_view bytes);

}  // namespace gvd
