#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The rough bisectors of section 4.2: in an ordinary face the segment between the midpoints of the two edges whose
/// ends have different nearest generators. So every such edge is crossed at its midpoint. Cost: O(n).
Crossings find_rough_segments(const Mesh& mesh, const NearestLabels& labels);

/// Puts these edges, ascending, back to one crossing at the midpoint, or none if their ends have one label.
void cross_at_midpoints(const Mesh& mesh, const std::vector<EdgeId>& edges, const NearestLabels& labels,
                        Crossings& crossings);

}  // namespace gvd
