#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"

namespace gvd {

/// Edges with a run inside that no chain of runs through common faces joins to a corner of its cell, ascending: an edge
/// sees the tables of its two faces only, and what the tables promise there may hang together with nothing.
/// Cost: O(c log c) for c crossings.
std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings);

}  // namespace gvd
