#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger polygons by clipping ears. Leaves
/// `twin` empty. A quadrilateral that is folded or crosses itself is a defect, and is cut if a diagonal gives two
/// triangles with an area. Throws Error{precondition} for any other folded or self-crossing polygon, and for a polygon
/// that is too complex.
/// Cost: O(n log n + n r) for each polygon of n corners, r of them not convex.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log);

/// The corners of a polygon in space, and their projection to a plane.
struct ProjectedPolygon {
  std::vector<Vec3> space;  ///< relative to the first corner, scaled so that the largest coordinate is 1
  /// The projection of `space` along the polygon's normal; all y are 0 if the polygon lies on a line.
  std::vector<Vec2> plane;
  bool is_on_line = false;
  /// Whether the projection turns by 2 pi in all, as every simple polygon does. Also false if there is no normal
  /// although the corners do not lie on a line; then the polygon crosses itself.
  bool turns_once = false;
};

/// Projects a polygon along its normal by Newell's formula, so that the orientation becomes counter-clockwise.
/// Input: three or more corners, as indices into `positions`, not all at the same position.
/// Cost: O(n).
ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions);

}  // namespace gvd
