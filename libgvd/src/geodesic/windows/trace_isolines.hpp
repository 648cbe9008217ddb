#pragma once

#include <vector>

#include "geodesic/windows/window_field.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Finds the curves of equal distance on the mesh on which the field was propagated, sorted by level. All windows must
/// have been kept. The chord tolerance is relative to `mean_edge`, in mesh units. See ExactField::isolines.
/// Cost: O(windows + levels on each edge and face).
std::vector<Isoline> trace_isolines(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                                    double mean_edge, const IsolineOptions& options);

}  // namespace gvd
