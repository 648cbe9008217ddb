#pragma once

#include <cstdint>
#include <vector>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Cuts components with one side only open, where the orientations of two faces disagree at fewer than 1 % of the
/// component's edges: along those of these edges where no flip of faces helps. Faces keep their orientations. Returns
/// the ends of the cut edges: the vertices that `cut_vertices` shall not count. Cost: O(n), and O(k log k) for k such
/// edges.
std::vector<std::int32_t> cut_twists(WorkFaces& work, DefectLog& log);

}  // namespace gvd
