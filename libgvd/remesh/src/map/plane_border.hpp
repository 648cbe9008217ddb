#pragma once

#include <vector>

#include "map/border_targets.hpp"
#include "map/flatten_disc.hpp"

namespace gvd {

/// How the border of a cell is put into the plane, round the origin.
enum class BorderShape {
  star,   ///< by angles and distances at the remesh's vertex: nearly the shape of the remesh's part
  round,  ///< on a circle: convex
};

/// Where the border of a cell is put. That of a cell at the boundary is a sector, whose corner is the anchor, at the
/// origin. Its two straight sides are the run along the boundary.
struct PlaneBorder {
  std::vector<BorderPoint> points;
  std::vector<Vec2> bases;  ///< of the ends of the targets, one more than targets; round: the first one again
};

/// `targets`: of the cell; at least three, or two at the boundary. Cost: O(k) for k halfedges.
PlaneBorder place_border(const CellSurface& surface, const Mesh& remesh, GeneratorId cell,
                         const std::vector<BorderTarget>& targets, BorderShape shape);

}  // namespace gvd
