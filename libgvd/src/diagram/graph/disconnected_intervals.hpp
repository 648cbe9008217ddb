#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"

namespace gvd {

/// Edges, ascending, with a label interval inside that no chain of intervals through common faces connects to a corner
/// of its cell. Such intervals occur since an edge knows only the tables of its two faces. Cost: O(c log c) for c
/// crossings.
std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings);

}  // namespace gvd
