#pragma once

#include <cstdint>
#include <vector>

#include "gvd/soup.hpp"
#include "mesh/repair/defect_log.hpp"

namespace gvd {

/// Welds vertices at one position: all of them in an STL, elsewhere those that a polygon edge joins.
/// Returns per input vertex the vertex that replaces it: itself, or an earlier one at the same position.
/// Cost: O(n log n) for an STL, else O(n).
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);

}  // namespace gvd
