#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Finds the crossings of the rough bisectors with the edges. On each half of an edge, they lie on the lower envelope
/// of the distances of the generators in the tables of the edge's two faces; these distances are linear from an end to
/// the midpoint.
///
/// Source: section 4.2 (rough bisectors), with the auxiliary midpoints of section 4.1. Deviation: the paper joins edge
/// midpoints in faces of two labels. Here a crossing lies where two distances are equal along the edge, and an edge may
/// have several crossings, because a cell can own the inside of an edge whose two ends belong to other cells.
/// Reports the first half of the step "bisectors". Cost: O(k) for the k edges near bisectors.
Crossings find_rough_crossings(const GrowthInput& input, const Progress& progress = {});

/// Replaces the crossings of the given edges, which ascend, by at most one crossing each, between the labels of the
/// edge's ends.
/// Cost: O(k) for k crossings and edges.
void cross_at_most_once(const GrowthInput& input, const std::vector<EdgeId>& edges, Crossings& crossings);

}  // namespace gvd
