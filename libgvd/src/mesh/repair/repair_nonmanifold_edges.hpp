#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/pair_halfedges.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Pairs halfedges at edges of three or more faces: neighbours round the edge stay together where the inside of the
/// surface lies between them. Halfedges without a partner stay cut apart. Faces of a component with one side only are
/// left out. `one_sided` is the result of `orient_faces`. Returns per vertex whether it is on such an edge.
/// Cost: O(n log n) for n halfedges of such edges.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);

}  // namespace gvd
