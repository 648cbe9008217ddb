#pragma once

#include "diagram/evaluation/reached_faces.hpp"
#include "diagram/evaluation/violations.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Checks properties (6) to (8) of `check_diagram`: components and Euler characteristics of the cells, Euler's formula
/// for the whole diagram, and the neighbours. Expects valid ids. Cost: O(n).
void check_topology(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations);

}  // namespace gvd
