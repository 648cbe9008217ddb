#pragma once

#include "diagram/graph/traced_diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The boundary loops of every cell, made of bisectors and of the mesh's boundary. Cost: O(k) for k arcs and boundary
/// edges.
IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced);

}  // namespace gvd
