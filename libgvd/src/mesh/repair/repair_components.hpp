#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Under DefectPolicy::largest: drops the faces of all components but the one with the largest area. `one_sided` is the
/// result of `orient_faces`. Throws Error{precondition} where the largest one has one side only. Cost: O(n).
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);

}  // namespace gvd
