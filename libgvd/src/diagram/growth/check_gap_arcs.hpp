#pragma once

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/growth.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Whether the arcs of a grown gap are in general position: around every branch point they follow each other
/// counter-clockwise in the order of their cells, and no two arcs of a face cross. Expects nodes that passed
/// `check_gap_nodes`. Cost: O(k^2) for k arcs.
bool check_gap_arcs(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown);

}  // namespace gvd
