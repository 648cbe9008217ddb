#pragma once

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Splits edges that were cut apart and still have both ends in common: all copies but the first get a midpoint.
///
/// A body may touch itself along an edge whose two ends have all their faces connected round them. Then each end has
/// one fan and stays one vertex. A mesh that identifies an edge by its two vertices would take the copies for one edge.
/// Splitting them changes no point of the surface.
/// Throws Error{precondition} where an edge is too short for a midpoint. Cost: O(n log n).
void split_touching_edges(WorkFaces& work, DefectLog& log);

}  // namespace gvd
