#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/grow_gaps.hpp"

namespace gvd {

/// Fills in the arcs and branch points of all crossed faces, ascending by face: by growth through the gaps, and by
/// assembly in all other faces. Growth may replace crossings and labels inside of the gaps. Counts the gaps. Cost:
/// O(n).
void close_gaps(const GrowthInput& input, const std::vector<Gap>& gaps, const GapGrowthPlan& plan,
                TracedDiagram& traced, const Progress& progress);

}  // namespace gvd
