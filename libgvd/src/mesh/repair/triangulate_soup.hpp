#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/work_faces.hpp"
#include "mesh/repair/work_polygons.hpp"

namespace gvd {

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger ones by clipping ears. `twin` is
/// left empty. Throws Error{precondition} for a polygon that crosses itself, or is too complex. Cost: see
/// `triangulate_soup_polygon.hpp`.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions);

}  // namespace gvd
