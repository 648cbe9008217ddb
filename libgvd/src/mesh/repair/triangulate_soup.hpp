#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger ones by clipping ears. `twin` is
/// left empty. A quadrilateral that is folded or crosses itself is a defect, and is cut where a diagonal leaves two
/// triangles with area. Throws Error{precondition} for any other such polygon, and for one too complex.
/// Cost: O(n log n + n r) for each polygon of n corners, r of them not convex.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log);

/// The corners of a polygon in space, and their projection to a plane.
struct ProjectedPolygon {
  std::vector<Vec3> space;  ///< relative to the first corner, scaled so that the largest coordinate is 1
  std::vector<Vec2> plane;  ///< of `space`, along the polygon's normal; all y are 0 where it lies on a line
  bool is_on_line = false;
  /// Whether the projection turns by 2 pi once round, as that of every simple polygon does. False where there is no
  /// normal either, although the corners do not lie on a line: then the polygon crosses itself.
  bool turns_once = false;
};

/// Projects a polygon along its normal by Newell's formula, so that the orientation becomes counter-clockwise.
/// Input: three or more corners, indices into `positions`, not all at one position. Cost: O(n).
ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions);

}  // namespace gvd
