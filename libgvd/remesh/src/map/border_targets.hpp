#pragma once

#include <vector>

#include "map/cut_into_cells.hpp"
#include "map/dual_polygons.hpp"

namespace gvd {

/// Where the map takes a halfedge of a cell's border that is between two cells: to a straight piece of a polygon. With
/// the polygon's corner of the cell, the apex, the piece is a triangle.
struct BorderTarget {
  HalfedgeId halfedge;
  const DualPolygon* polygon = nullptr;
  Vec2 apex, from, to;            ///< points of the polygon
  double at_from = 0, at_to = 1;  ///< how far they are from the polygon's centre; 1 at the crossing
};

/// Sets where the bisectors cross the remesh's edges: at the point of the edge nearest to the bisector, but not near
/// the ends. Cost: O(k) for k halfedges of borders.
void place_crossings(const CellSurface& surface, DualPolygons& polygons);

/// The targets of a cell's border, in its order, without the run along the mesh's boundary.
///
/// A run goes from the centre of a polygon to the centre of the next one. Between them it crosses the edge that joins
/// the two cells' vertices. The vertices are spaced by their distances. Both cells have the same targets, to the last
/// bit. Throws Error{no_valid_result} where a run joins boundary and boundary. Cost: O(k) for k halfedges.
std::vector<BorderTarget> border_targets(const CellSurface& surface, const DualPolygons& polygons, GeneratorId cell);

}  // namespace gvd
