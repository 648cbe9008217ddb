#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/grow_gaps.hpp"

namespace gvd {

/// Replaces the crossings inside the grown gaps by those that grew, appends their arcs and branch points to
/// `traced.faces`, and gives the vertices that growth moved their new labels. Cost: O(n + k log k) for k crossings.
void install_grown_gaps(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced);

}  // namespace gvd
