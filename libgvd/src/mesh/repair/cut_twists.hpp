#pragma once

#include <cstdint>
#include <vector>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Cuts one-sided components open if the orientations of two faces disagree at fewer than 1 % of the component's edges.
/// Cuts along the edges at which no flip of faces helps. Faces keep their orientations. Returns the ends of the cut
/// edges, which `cut_vertices` must not count. Cost: O(n), and O(k log k) for k edges with disagreeing faces.
std::vector<std::int32_t> cut_twists(WorkFaces& work, DefectLog& log);

}  // namespace gvd
