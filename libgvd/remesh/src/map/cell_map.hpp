#pragma once

#include <vector>

#include "map/border_targets.hpp"
#include "map/flatten_disc.hpp"

namespace gvd {

/// A cell in the plane: the surface's faces by a convex combination map, and the remesh's part by a fan of triangles.
/// Both have the same border, vertex by vertex. Going from one to the other is the map.
struct PlaneCell {
  PlaneDisc disc;
  VertexId vertex;                    ///< of the remesh: where the fan's apex goes
  SurfacePoint origin;                ///< of the surface: what goes to that vertex
  Vec2 apex = Vec2::Zero();           ///< of the fan: inside, or on the border of a cell at the boundary
  std::vector<BorderTarget> targets;  ///< the bases of the fan's triangles, and where they go
  std::vector<Vec2> bases;            ///< their ends in the plane, one more than targets

  /// The point of the remesh for a point of the disc.
  SurfacePoint image(const Vec2& point) const;
};

/// What the map of a cell needs.
struct CellMapInput {
  const Mesh& surface;  ///< before it was cut
  const RemeshResult& result;
  const CellSurface& cells;
  const DualPolygons& polygons;
};

/// Flattens a cell with these faces, and checks that no triangle is turned round: of the disc, and of the fan.
///
/// A cell inside becomes a disc of many corners, in which the generator is the fan's apex. One at the boundary becomes
/// a sector of it, whose two straight sides are the run along the boundary, and whose corner is the anchor.
/// Throws Error{no_valid_result} where the check fails. Cost: a sparse system of the cell's vertices, or two.
PlaneCell flatten_cell(const CellMapInput& input, GeneratorId cell, const std::vector<FaceId>& faces);

}  // namespace gvd
