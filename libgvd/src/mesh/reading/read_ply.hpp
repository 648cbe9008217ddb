#pragma once

#include <string_view>

#include "gvd/read_soup.hpp"

namespace gvd {

/// PLY, text and binary: the elements `vertex` and `face`; other elements and properties are skipped. Errors,
/// properties and cost as of `parse_soup`.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

}  // namespace gvd
