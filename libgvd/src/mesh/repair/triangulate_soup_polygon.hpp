#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

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
