#pragma once

#include <string_view>

#include "gvd/read_soup.hpp"

namespace gvd {

/// Wavefront OBJ: the statements `v` and `f`; all others are skipped. Errors, properties and cost as of `parse_soup`.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

}  // namespace gvd
