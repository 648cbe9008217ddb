#pragma once

#include <string_view>

#include "gvd/read_soup.hpp"

namespace gvd {

/// Geomview's OFF in text, with or without colours, normals and texture coordinates, which are skipped. Each vertex and
/// each face begins a line. Errors, properties and cost as of `parse_soup`.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

/// Whether a word is the keyword of an OFF file: OFF, COFF, NOFF, STCNOFF, 4OFF, nOFF and so on.
bool is_off_keyword(std::string_view word);

}  // namespace gvd
