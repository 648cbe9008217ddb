#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"
#include "mesh/repair/work_polygons.hpp"

namespace gvd {

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger ones by clipping ears. `twin` is
/// left empty. A quadrilateral that crosses itself is a defect, and is cut where a diagonal leaves two triangles with
/// area. Throws Error{precondition} for any other polygon that crosses itself, or is too complex. Cost: see
/// `triangulate_soup_polygon.hpp`.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log);

}  // namespace gvd
