#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A part of the mesh's boundary that lies in one cell: between two ends of bisectors, or a whole loop.
struct BoundaryRun {
  GeneratorId cell;
  SurfacePoint middle;  ///< half way along the run
};

/// All runs, loop by loop in the order of their first halfedge; loops that no generator reaches have none.
/// Cost: O(k log k) for k boundary edges and ends of bisectors.
std::vector<BoundaryRun> list_boundary_runs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
