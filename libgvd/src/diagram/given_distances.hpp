#pragma once

#include <vector>

#include "geodesic/marching/fast_marching.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/trace_diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Makes the generator tables of the caller's distances, like those that marching makes of its own distances. Every
/// generator of a component has a finite distance at each vertex of the component; an entry is in a face's table unless
/// another generator is nearer at all three corners. Throws as `trace_diagram` does. Reports the step "distances".
/// Cost: O(n) for each row.
FastMarchingResult tabulate_distances(const WorkingMesh& working, const std::vector<SurfacePoint>& generators,
                                      const DistanceSolver& solver, const Progress& progress);

}  // namespace gvd
