#pragma once

#include <vector>

#include "geodesic/windows/window_field.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The curves of equal distance on the mesh that the field was propagated on, by level. All windows must have been
/// kept. `mean_edge`: the length that the chord tolerance is relative to, mesh units. See ExactField::isolines.
/// Cost: O(windows + levels on each edge and face).
std::vector<Isoline> trace_isolines(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                                    double mean_edge, const IsolineOptions& options);

}  // namespace gvd
