#pragma once

#include <vector>

#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "map/cut_into_cells.hpp"
#include "map/dual_polygons.hpp"
#include "mesh/flatten_disc.hpp"

namespace gvd {

/// The lengths from a path's first vertex to each of its vertices, mesh units. Cost: O(k).
std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path);

/// The straight piece of a polygon to which the map takes a halfedge of a cell's border that is between two cells.
/// Together with the apex, which is the polygon's corner for the cell, the piece makes a triangle.
struct BorderTarget {
  HalfedgeId halfedge;
  const DualPolygon* polygon = nullptr;
  Vec2 apex, from, to;            ///< points of the polygon
  double at_from = 0, at_to = 1;  ///< how far they are from the polygon's centre; 1 at the crossing
};

/// Sets where the bisectors cross the remesh's edges: at the point of the edge nearest to the bisector, but not near
/// the ends. Cost: O(k) for k halfedges of borders.
void place_crossings(const CellSurface& surface, DualPolygons& polygons);

/// A cell in the plane: the surface's faces by a convex combination map, and the remesh's part by a fan of triangles.
/// Both have the same border, vertex by vertex, so that a point can go from one to the other.
struct PlaneCell {
  PlaneDisc disc;
  VertexId vertex;                    ///< the vertex of the remesh to which the fan's apex goes
  SurfacePoint origin;                ///< the point of the surface that goes to that vertex
  Vec2 apex = Vec2::Zero();           ///< of the fan: inside, or on the border of a cell at the boundary
  std::vector<BorderTarget> targets;  ///< the bases of the fan's triangles, and where they go
  std::vector<Vec2> bases;            ///< their ends in the plane, one more than targets

  /// The point of the remesh for a point of the disc.
  SurfacePoint image(const Vec2& point) const;
};

struct CellMapInput {
  const Mesh& surface;  ///< before it was cut
  const RemeshResult& result;
  const CellSurface& cells;
  const DualPolygons& polygons;
};

/// Flattens a cell with these faces, and checks that no triangle of the disc or the fan is turned over.
///
/// A cell inside the surface becomes a disc of many corners, in which the generator is the fan's apex. A cell at the
/// boundary becomes a sector of a disc. The two straight sides of the sector are the run along the boundary, and its
/// corner is the anchor. Returns Error{no_valid_result} if the check fails, or if both ends of a run are on the
/// boundary. Cost: a sparse system of the cell's vertices, or up to three.
OrError<PlaneCell> flatten_cell(const CellMapInput& input, GeneratorId cell, const std::vector<FaceId>& faces);

/// The point of these faces that is nearest to a point in space. Faces that are turned away from `normal` count only if
/// there are no others: opposite sheets of a thin part can share a vertex. Cost: O(k).
SurfacePoint find_nearest_facing(const Mesh& mesh, const std::vector<FaceId>& faces, const Vec3& point,
                                 const Vec3& normal);

}  // namespace gvd
