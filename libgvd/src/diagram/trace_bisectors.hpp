#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Follows the arcs from branch point to branch point, and fills in the bisectors, their total length and the branch
/// points, in the faces of the input mesh. Counts unresolved ends in the diagram's report. Several threads compute the
/// points. Reports the first half of the step "cells".
/// Cost: O(k) for k arcs.
void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram);

}  // namespace gvd
