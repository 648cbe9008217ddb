#pragma once

#include <vector>

#include "diagram/graph/face_diagram.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Joins the crossings in every crossed face except those in `skipped`, which ascend, and appends the arcs and branch
/// points to `diagram`. Reports the last quarter of the step "bisectors".
///
/// Source: none; the paper draws one segment in a face of two labels (section 4.2) and leaves all other faces to
/// growth.
/// Cost: O(k) for k faces near bisectors.
void assemble_faces(const GrowthInput& input, const Crossings& crossings, const std::vector<FaceId>& skipped,
                    FaceDiagram& diagram, const Progress& progress = {});

}  // namespace gvd
