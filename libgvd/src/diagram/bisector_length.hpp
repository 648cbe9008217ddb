#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Length of a bisector's polyline in mesh units. For a closed bisector, it includes the segment from the last point to
/// the first. The points lie on `mesh`. Cost: O(points).
double compute_length(const Mesh& mesh, const Bisector& bisector);

}  // namespace gvd
