#pragma once

#include "diagram/evaluation/violations.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Checks that all arrays have the mesh's sizes and that every id names an element of the mesh or of the diagram; the
/// other checks look these ids up. Findings count under properties (1) to (4) of `check_diagram`. Cost: O(n).
void check_ids(const Mesh& mesh, const Diagram& diagram, Violations& violations);

}  // namespace gvd
