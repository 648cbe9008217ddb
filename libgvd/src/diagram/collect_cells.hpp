#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Fills in face labels, pieces and cells by several threads; expects the bisectors in `diagram`, for a cell's
/// neighbours. Reports the second half of the step "cells". Cost: O(n).
void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram);

}  // namespace gvd
