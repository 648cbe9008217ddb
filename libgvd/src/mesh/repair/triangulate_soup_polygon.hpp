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
  self_crossing,  ///< in the projection along its normal; nothing was cut
  too_complex,    ///< more than kMostEarTests would be needed
};

/// Point-in-triangle tests that one polygon may cost: about a second. Reached by concave polygons of some 20,000
/// corners.
inline constexpr std::int64_t kMostEarTests = 100'000'000;

/// Whether two vertices are joined by an edge already.
using EdgeQuery = std::function<bool(std::int32_t, std::int32_t)>;

/// Cuts a polygon in space into triangles of its own orientation by clipping ears, best shaped ones first.
///
/// Inputs: four or more corners, neighbours at different positions; a vertex may come twice (a polygon with a bridge to
/// its hole). Diagonals have a positive length and are no edges yet, unless there is no other way.
/// Triangles are appended to `triangles`. Deterministic. Cost: O(n log n + n r) time for r corners that are not convex.
PolygonShape triangulate_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions,
                                 const EdgeQuery& is_edge, std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace gvd
