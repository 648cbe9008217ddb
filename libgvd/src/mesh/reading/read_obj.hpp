#pragma once

#include <optional>
#include <string_view>

#include "gvd/mesh_property.hpp"
#include "gvd/read_soup.hpp"

namespace gvd {

/// Wavefront OBJ: the statements `v` and `f`; all others are skipped. Errors, properties and cost as of `parse_soup`.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

/// The statements `v`, `vt` and `f`; none where no corner refers to a `vt` of the file. Errors and cost as of
/// `parse_soup`.
std::optional<CornerTexture> parse_obj_texture(std::string_view bytes, std::string_view name);

}  // namespace gvd
