#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/collect_cells.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Turns a traced diagram of exact distances without weights into the `Diagram` of the input, which has its generators.
/// Fills in all that is not counted by the solver. `known`: null if all pieces are to be traced.
void finish_diagram(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                    Diagram& diagram, KnownPieces* known = nullptr);

/// The chord tolerance as a length, mesh units.
double chord_length(const Mesh& mesh, const DiagramOptions& options);

}  // namespace gvd
