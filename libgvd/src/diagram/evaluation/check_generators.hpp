#pragma once

#include "diagram/evaluation/violations.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Checks property (1) of `check_diagram`: every generator lies in its own cell, whose area is not negative.
/// Expects valid ids. Cost: O(n + p) for p corners of pieces.
void check_generators(const Mesh& mesh, const Diagram& diagram, Violations& violations);

}  // namespace gvd
