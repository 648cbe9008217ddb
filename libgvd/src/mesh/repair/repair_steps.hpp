#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/repair/work_soup.hpp"

// The steps of `build_mesh` in their order. Each one logs the defects that it repairs, and the log throws under
// DefectPolicy::error. All of them are deterministic. `positions` are those of the soup.
namespace gvd {

/// Throws Error{precondition} unless every index is in range, there is a face, and every coordinate is finite and of a
/// size that can be computed with (kLargestCoordinate, kSmallestExtent). Cost: O(n).
void examine_soup(const PolygonSoup& soup);

/// Welds vertices at one position: all of them in an STL, elsewhere those that a polygon edge joins.
/// Returns per input vertex the vertex that replaces it: itself, or an earlier one at the same position.
/// Cost: O(n log n) for an STL, else O(n).
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);

/// Takes repeated corners out of every polygon and drops polygons of fewer than three corners. `weld` is the table of
/// `weld_vertices`. Throws Error{precondition} where no polygon is left. Cost: O(n).
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);

/// Drops polygons with the corners of an earlier one, in either direction. Two faces back to back that no other face
/// touches stay: they are a closed surface. Cost: O(n) where degrees are bounded, O(n log n) at worst.
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger ones by clipping ears. `twin` is
/// left empty. A quadrilateral that crosses itself is a defect, and is cut where a diagonal leaves two triangles with
/// area. Throws Error{precondition} for any other polygon that crosses itself, or is too complex. Cost: that of
/// `triangulate_polygon` for each.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log);

/// Sets `twin` of the two halfedges of each edge with two faces, whatever their direction. Returns the edges of three
/// or more faces, in the order of `visit_edges`. Cost: that of `visit_edges`.
EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count);

/// Flips faces so that each component follows the majority of its faces. The halfedges in `nonmanifold_edges` follow
/// the flips. Returns per face 1 where its component has one side only; DefectPolicy::error and ::repair refuse that
/// with Error{precondition}. Cost: O(n).
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log);

/// Pairs halfedges at edges of three or more faces: neighbours round the edge stay together where the inside of the
/// surface lies between them. Halfedges without a partner stay cut apart. Faces of a component with one side only are
/// left out. `one_sided` is the result of `orient_faces`. Returns per vertex whether it is on such an edge.
/// Cost: O(n log n) for n halfedges of such edges.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);

/// Under DefectPolicy::largest: drops the faces of all components but the one with the largest area. `one_sided` is the
/// result of `orient_faces`. Throws Error{precondition} where the largest one has one side only. Cost: O(n).
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);

/// Gives every fan of faces a vertex of its own: the first fan keeps the vertex, the others get copies at the end.
/// Fills `source` and `positions`. A vertex counts as a defect unless it is `on_cut_edge`, the result of `cut_edges`.
/// Cost: O(n).
void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log);

/// Splits edges that were cut apart and still have both ends in common: all copies but the first get a midpoint.
///
/// A body may touch itself along an edge whose two ends have all their faces connected round them. Then each end has
/// one fan and stays one vertex. A mesh that identifies an edge by its two vertices would take the copies for one edge.
/// Splitting them changes no point of the surface.
/// Throws Error{precondition} where an edge is too short for a midpoint. Cost: O(n log n).
void split_touching_edges(WorkFaces& work, DefectLog& log);

}  // namespace gvd
