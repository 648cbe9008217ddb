#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// The sine of an angle at or below this counts as 0. Coordinates scaled to 1 carry a rounding error of about 1e-16
/// each. The sine of a corner between sides a thousandth as long has one of about 1e-13; this is ten times as much.
inline constexpr double kFlatSine = 1e-12;

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
