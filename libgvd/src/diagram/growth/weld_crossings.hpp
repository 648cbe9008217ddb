#pragma once

#include <vector>

#include "diagram/growth/refine_bisectors.hpp"

namespace gvd {

/// Moves every crossing to the mean of the estimates of its two faces.
///
/// Source: section 4.2 (consistency enforcement). A crossing without an estimate stays. Deviation: crossings keep their
/// order on the edge, and kCrossingGap from each other and from its ends. Cost: O(k) for k crossings and estimates.
void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings);

}  // namespace gvd
