#pragma once

#include <optional>
#include <string_view>

#include "gvd/mesh_property.hpp"
#include "gvd/read_soup.hpp"

namespace gvd {

/// PLY, text and binary: the elements `vertex` and `face`; other elements and properties are skipped. Errors,
/// properties and cost as of `parse_soup`.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

/// One property of the element `vertex`, or else of `face`, that is a number: none where there is no such property.
/// Errors and cost as of `parse_soup`.
std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property,
                                               std::string_view name);

/// What read_mesh_attributes returns. Errors and cost as of `parse_soup`.
MeshAttributes parse_ply_attributes(std::string_view bytes, std::string_view name);

}  // namespace gvd
