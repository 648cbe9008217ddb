#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/weld_crossings.hpp"
#include "diagram/paper/midpoint_distances.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Refines the rough segment of every ordinary face (section 4.2, figure 6): both generators are unfolded into the
/// face's plane from their distances at the segment's ends, each to the side of the corners that it is nearest to. The
/// segment moves to the bisector of the two images.
///
/// Returns an estimate for each end, ascending by face; none where the bisector leaves the edge, or where the tables
/// miss one of the two generators. Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_segments(const Mesh& mesh, const MidpointDistances& midpoints,
                                              const Crossings& crossings);

}  // namespace gvd
