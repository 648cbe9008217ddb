#pragma once

#include <cstdint>
#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "gvd/ids.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The connected components of every cell. An island is a component without the vertex of its generator; a valid
/// diagram has none.
struct CellComponents {
  IdVector<GeneratorId, std::int32_t> count;  ///< 1 if the cell is connected
  std::vector<EdgeId> island_edges;           ///< all edges of the faces in islands, ascending
  std::vector<VertexId> island_vertices;      ///< ascending
};

/// Finds the components of all cells, and the islands. Cost: O(k) time for k crossings, and 4 bytes a face.
CellComponents find_cell_components(const WorkingMesh& working, const TracedDiagram& traced);

}  // namespace gvd
