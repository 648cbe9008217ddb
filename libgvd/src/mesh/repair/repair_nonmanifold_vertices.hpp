#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// Gives every fan of faces a vertex of its own: the first fan keeps the vertex, the others get copies at the end.
/// Fills `source` and `positions`. A vertex counts as a defect unless it is `on_cut_edge`, the result of `cut_edges`.
/// Cost: O(n).
void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log);

}  // namespace gvd
