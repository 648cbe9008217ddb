#pragma once

#include "diagram/evaluation/violations.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Checks properties (3) to (5) of `check_diagram`: the points, sides and ends of bisectors, and the bisectors at each
/// branch point. Expects valid ids. Cost: O(k) for k points.
void check_bisectors(const Mesh& mesh, const Diagram& diagram, Violations& violations);

}  // namespace gvd
