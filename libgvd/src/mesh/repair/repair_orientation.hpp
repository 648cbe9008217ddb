#pragma once

#include <vector>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/pair_halfedges.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Flips faces so that each component follows the majority of its faces. The halfedges in `nonmanifold_edges` follow
/// the flips. Returns per face 1 where its component has one side only; DefectPolicy::error and ::repair refuse that
/// with Error{precondition}. Cost: O(n).
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log);

}  // namespace gvd
