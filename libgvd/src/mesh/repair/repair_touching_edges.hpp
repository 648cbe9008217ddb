#pragma once

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Splits edges that were cut apart and still have both ends in common: all copies but the first get a midpoint.
///
/// Where a body touches itself along an edge and its faces are connected round both ends of that edge, each end has one
/// fan and stays one vertex. A mesh that identifies an edge by its two vertices would take the copies for one edge.
/// Splitting them changes no point of the surface.
/// Throws Error{precondition} where an edge is too short for a midpoint. Cost: O(n log n).
void split_touching_edges(WorkFaces& work, DefectLog& log);

}  // namespace gvd
