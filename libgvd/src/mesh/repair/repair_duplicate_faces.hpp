#pragma once

#include <cstddef>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_polygons.hpp"

namespace gvd {

/// Drops polygons with the corners of an earlier one, in either direction. Two triangles back to back that no other
/// face touches stay: they are a closed surface. Cost: O(n) where degrees are bounded, O(n log n) at worst.
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);

}  // namespace gvd
