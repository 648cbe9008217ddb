#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Pairs halfedges at edges of three or more faces: neighbours round the edge stay together where the inside of the
/// surface lies between them. Halfedges without a partner stay cut apart. Faces of a component with one side only are
/// left out. `one_sided` is the result of `orient_faces`. Returns per vertex whether it is on such an edge.
/// Cost: O(n log n) for n halfedges of such edges.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);

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
