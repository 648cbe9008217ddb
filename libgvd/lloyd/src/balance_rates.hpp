#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// For each bisector, the rate at which it passes mass from the cell on its left to the cell on its right as the weight
/// on the left grows: the integral of density / |difference of the two distances' gradients| along it, in square mesh
/// units per mesh unit if the density is 1. `field`: the windows from which the diagram was traced. The result does not
/// depend on the number of threads. Cost: O(windows near bisectors + points of bisectors).
std::vector<double> integrate_balance_rates(const WorkingMesh& working, const WindowField& field,
                                            const Diagram& diagram, const Density& density,
                                            const ParallelChunks& parallel);

}  // namespace gvd
