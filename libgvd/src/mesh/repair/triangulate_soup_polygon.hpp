#pragma once

#include <array>
#include <cstdint>
#include <functional>
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

enum class PolygonShape {
  simple,         ///< cut into triangles
  self_crossing,  ///< in the projection along its normal; no triangle was added
  too_complex,    ///< more than kMostEarTests would be needed; no triangle was added
};

/// Largest number of point-in-triangle tests for one polygon: they take about a second. Concave polygons of about
/// 20,000 corners reach it.
inline constexpr std::int64_t kMostEarTests = 100'000'000;

/// Whether two vertices are joined by an edge already.
using EdgeQuery = std::function<bool(std::int32_t, std::int32_t)>;

/// Cuts a polygon in space into triangles of its own orientation by clipping ears, the best shaped ones first.
///
/// Inputs: four or more corners, neighbours at different positions; a vertex may come twice (a polygon with a bridge to
/// its hole). `is_edge` is asked for each diagonal: one that is an edge already is used only where no other is left.
/// Appends the triangles to `triangles`. Diagonals have a positive length. Deterministic.
/// Cost: O(n log n + n r) time for n corners, r of them not convex.
PolygonShape triangulate_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions,
                                 const EdgeQuery& is_edge, std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace gvd
