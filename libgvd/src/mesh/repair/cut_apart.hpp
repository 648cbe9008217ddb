#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Pairs halfedges at edges of three or more faces: neighbours around the edge stay together if the inside of the
/// surface lies between them. Halfedges without a partner stay cut apart, and so do all faces of one-sided components.
/// `one_sided` is the result of `orient_faces`. Returns for each vertex whether it is on such an edge.
/// Cost: O(n log n) for n halfedges of such edges.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);

/// Gives every fan of faces a vertex of its own: the first fan keeps the vertex, and all other fans get copies, which
/// are appended. Fills `source` and `positions`. A vertex counts as a defect unless it is `on_cut_edge`, the result of
/// `cut_edges`.
/// Cost: O(n).
void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log);

/// Splits edges that were cut apart but still have both ends in common. All copies except the first get a midpoint.
///
/// A body may touch itself along an edge although all faces around each end are connected. Then each end has only one
/// fan and stays a single vertex, and a mesh, which identifies an edge by its two vertices, would take the copies for
/// one edge. Splitting them changes no point of the surface.
/// Throws Error{precondition} if an edge is too short for a midpoint. Cost: O(n log n).
void split_touching_edges(WorkFaces& work, DefectLog& log);

}  // namespace gvd
