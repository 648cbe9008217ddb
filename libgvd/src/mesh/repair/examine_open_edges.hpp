#pragma once

#include <optional>

#include "gvd/soup.hpp"

namespace gvd {

/// Counts copies of vertices along open edges of the mesh and the edges that welding would close, and adds notes about
/// them. `weld_tolerance`: the tolerance of `weld_soup`, if it was called; if it joined nothing, a note says so. Cost:
/// O(n log n) for n open edges.
void examine_open_edges(CheckedMesh& checked, std::optional<double> weld_tolerance);

}  // namespace gvd
