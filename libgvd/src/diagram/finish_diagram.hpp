#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/collect_cells.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Turns a traced diagram of exact distances without weights into the `Diagram` of the input. `diagram` must have its
/// generators already. Fills in everything except the solver's counts. `known` is null if all pieces have to be traced.
void finish_diagram(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                    Diagram& diagram, KnownPieces* known = nullptr);

/// The chord tolerance as a length, mesh units.
double chord_length(const Mesh& mesh, const DiagramOptions& options);

}  // namespace gvd
