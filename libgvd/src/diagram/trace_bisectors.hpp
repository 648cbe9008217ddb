#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Follows the arcs from branch point to branch point and fills in bisectors, branch points and their total length, in
/// the input mesh's faces. Counts ends that are unresolved in its report. Several threads compute the points. Reports
/// the first half of the step "cells".
/// Cost: O(k) for k arcs.
void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram);

}  // namespace gvd
