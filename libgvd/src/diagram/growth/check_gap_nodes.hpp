#pragma once

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/gap_edges.hpp"
#include "diagram/growth/growth.hpp"

namespace gvd {

/// Whether the arcs of a grown gap are connected by its nodes as they must be.
///
/// Properties: (1) every crossing of the rim is exactly one node and ends one arc; (2) every new crossing ends one arc
/// in each of its faces; (3) every branch point ends three; (4) each end of an arc lies in the arc's face or on its
/// boundary, a crossing between the arc's two cells. Cost: O(k log k) for k nodes and arcs.
bool check_gap_nodes(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GapEdges& edges,
                     const GrownGap& grown);

}  // namespace gvd
