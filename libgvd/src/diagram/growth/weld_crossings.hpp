#pragma once

#include <vector>

#include "diagram/growth/refine_bisectors.hpp"

namespace gvd {

/// Puts every crossing at the mean of what its two faces estimate, so that the bisector's parts meet on the edge.
///
/// Source: section 4.2 (the weld across edges). A crossing without an estimate stays; crossings keep their order and
/// their gap on the edge.
/// Cost: O(k).
void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings);

}  // namespace gvd
