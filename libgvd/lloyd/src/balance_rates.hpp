#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The rate at which each bisector passes mass from the cell on its left to that on its right while the weight on the
/// left grows: the integral of density / |difference of the two distances' gradients| along it, square mesh units per
/// mesh unit where the density is 1. By bisector. `field`: the windows of which the diagram was traced.
/// Does not depend on the number of threads. Cost: O(windows near bisectors + points of bisectors).
std::vector<double> integrate_balance_rates(const WorkingMesh& working, const WindowField& field,
                                            const Diagram& diagram, const Density& density,
                                            const ParallelChunks& parallel);

}  // namespace gvd
