#pragma once

#include <cstdint>
#include <vector>

#include "gvd/soup.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_polygons.hpp"

namespace gvd {

/// Takes repeated corners out of every polygon and drops polygons of fewer than three corners. `weld` is the table of
/// `weld_vertices`. Throws Error{precondition} where no polygon is left. Cost: O(n).
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);

}  // namespace gvd
