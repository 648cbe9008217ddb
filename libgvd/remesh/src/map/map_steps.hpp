#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/plane.hpp"
#include "gvd/remesh.hpp"
#include "gvd/segment.hpp"
#include "mesh/flatten_disc.hpp"

// The steps of map_to_remesh, in their order: the cells of the surface, the polygons of the branch points, where a
// cell's border goes on the remesh and in the plane, the disc of the cell, its map, and the nearest points where a
// check fails.

namespace gvd {

// cut_into_cells.cpp

/// Consecutive halfedges of a cell's border, along one other cell or along the mesh's boundary.
struct BorderRun {
  GeneratorId other;           ///< invalid along the mesh's boundary
  std::size_t begin = 0, end;  ///< into the loop; end is not included
};

/// The border of a cell that is a disc.
struct CellBorder {
  std::vector<HalfedgeId> loop;  ///< with the cell on their left, counter-clockwise
  std::vector<BorderRun> runs;   ///< in the loop's order; one along the mesh's boundary comes last

  bool at_boundary() const { return !runs.back().other.valid(); }
};

/// The vertices of a run of the border, from its first to its last. Cost: O(k).
std::vector<VertexId> run_vertices(const Mesh& mesh, const CellBorder& border, const BorderRun& run);

/// The borders of the cells of a mesh whose faces have labels from 0 to `cells` - 1.
///
/// Throws Error{no_valid_result} where a face has no label, a cell is no disc or has one run only, or two cells share
/// several runs. Cost: O(n), and O(k log k) for a cell with k neighbours.
IdVector<GeneratorId, CellBorder> trace_cell_borders(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label,
                                                     std::size_t cells);

/// A surface cut into the cells of its remesh, ready for a one-to-one map.
///
/// Properties: (1) every cell is a disc, and the surface's vertices come first, in their order; (2) between two branch
/// points, a run along another cell has an inner vertex; (3) the border of a cell at the boundary has an anchor inside
/// its run along the boundary: the generator, or the nearest point; (4) inside a cell no edge joins two vertices of
/// that run on the same side of the anchor, itself included.
struct CellSurface {
  CutMesh cut;
  IdVector<GeneratorId, CellBorder> borders;
  IdVector<GeneratorId, VertexId> anchors;  ///< invalid for cells that are not at the boundary
};

/// Cuts along the bisectors, and splits edges for properties (2) to (4).
/// Throws Error{no_valid_result} where the cells are no discs, and what cut_faces throws. Cost: O(n log n).
CellSurface cut_into_cells(const Mesh& surface, const RemeshResult& result, const Progress& progress = {});

// map_to_remesh.cpp

/// The faces of a remesh that stand for one branch point: a regular polygon in the plane, cut into triangles.
///
/// A map to the plane that is affine on each triangle takes the faces to it. Corner i stands for the i-th cell round
/// the branch point, counter-clockwise.
struct DualPolygon {
  struct Triangle {
    FaceId face;
    std::array<std::size_t, 3> corners{};  ///< of the polygon, in the order of the face's
  };
  std::vector<GeneratorId> cells;
  std::vector<Triangle> triangles;
  Vec2 centre = Vec2::Zero();  ///< the image of the branch point: inside, or on a side at the boundary
  /// Parameters at which the bisectors cross the sides, from 0 at a corner to 1 at the next one.
  std::vector<double> crossings;

  Vec2 corner(std::size_t i) const {
    return unit_vector(2 * std::numbers::pi * double(i % cells.size()) / double(cells.size()));
  }
  /// The point where the bisector crosses the side from corner i to the next one.
  Vec2 crossing(std::size_t i) const { return corner(i) + crossings[i] * (corner(i + 1) - corner(i)); }
  /// The number of a cell; cells.size() if it is none of them.
  std::size_t find(GeneratorId cell) const { return std::find(cells.begin(), cells.end(), cell) - cells.begin(); }
  /// The point of the remesh that the map takes to `point`, which is in the polygon but for rounding.
  SurfacePoint on_remesh(const Vec2& point) const;
};

/// The polygons of a remesh, one for each vertex of the cut surface at which three or more cells meet.
class DualPolygons {
 public:
  /// Vertex i of `remesh` stands for the cell with label i. Refers to `remesh`, which must outlive it.
  /// Throws Error{no_valid_result} unless every face of the remesh belongs to exactly one polygon.
  /// Cost: O(n), and O(k^2) for k cells round a vertex.
  DualPolygons(const Mesh& cut, const IdVector<FaceId, GeneratorId>& label, const Mesh& remesh);

  /// Null where fewer than three cells meet.
  const DualPolygon* at(VertexId v) const { return number_[v] < 0 ? nullptr : &polygons_[number_[v]]; }

  /// Sets where the bisector between two cells crosses the remesh's edge, if it begins or ends at v. The polygon's side
  /// goes from cell a to cell b, `t` from 0 to 1.
  void set_crossing(VertexId v, GeneratorId a, double t) {
    if (number_[v] < 0) return;
    DualPolygon& polygon = polygons_[number_[v]];
    polygon.crossings[polygon.find(a)] = t;
  }

  const Mesh& remesh() const { return remesh_; }

 private:
  void add(const Mesh& cut, VertexId v, std::vector<GeneratorId> cells);
  void fill(DualPolygon& polygon, VertexId at);
  HalfedgeId find_halfedge(GeneratorId from, GeneratorId to, VertexId at) const;

  const Mesh& remesh_;
  std::vector<DualPolygon> polygons_;
  IdVector<VertexId, std::int32_t> number_;  ///< of the polygon; -1 for none
  IdVector<FaceId, char> is_used_;           ///< per face of the remesh
};

// cell_map.cpp: where borders go

/// The lengths from a path's first vertex to each of its vertices, mesh units. Cost: O(k).
std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path);

/// Scales ascending numbers that begin with 0 so that the last one is `last`, bit by bit. Makes their distances
/// more even.
/// `even_share`: share of even spacing in their distances, in [0, 1]. It keeps numbers apart that nearly coincide.
/// Needs two numbers at least, of which the last one is above 0. Cost: O(k).
void scale_and_even(std::vector<double>& values, double last, double even_share);

/// The straight piece of a polygon to which the map takes a halfedge of a cell's border that is between two cells. With
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

/// The point of these faces that is nearest to a point in space. Faces that are turned away from `normal` count only if
/// there are no others: opposite sheets of a thin part can share a vertex. Cost: O(k).
SurfacePoint find_nearest_facing(const Mesh& mesh, const std::vector<FaceId>& faces, const Vec3& point,
                                 const Vec3& normal);

// map_to_remesh.cpp

/// The nearest point of the remesh for each vertex of the surface, on the triangles at its cell's vertex and that one's
/// neighbours. `map_to_remesh` says more. Several vertices may have the same point.
/// Throws Error{precondition} where a vertex is in no cell. Cost: O(n) for vertices of bounded valence.
IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads,
                                                const Progress& progress = {});

}  // namespace gvd
