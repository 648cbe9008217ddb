#pragma once

#include "diagram/evaluation/reached_faces.hpp"
#include "diagram/evaluation/violations.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Checks property (2) of `check_diagram`. Labels and pieces cover each reached face once. Cells have the area of their
/// faces and pieces. Vertices have the label of the faces and pieces at them. Expects valid ids. Cost: O(n).
void check_partition(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations);

}  // namespace gvd
