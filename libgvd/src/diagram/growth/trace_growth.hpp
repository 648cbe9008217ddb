#pragma once

#include "diagram/graph/traced_diagram.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "gvd/diagram.hpp"

namespace gvd {

/// The paper's tracer: rough bisectors, refined and welded (4.2), and growth through the gaps (4.3).
///
/// Whether the diagram is complete does not depend on the growth: a gap that growth does not close is closed by the
/// assembly of its edge crossings. Cells are connected: a run of a cell that hangs together with nothing is taken away.
/// Counts gaps and relabelled vertices in `report`; reports the steps "bisectors" and "growth". Cost: O(n).
TracedDiagram trace_growth(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options,
                           DiagramReport& report);

}  // namespace gvd
