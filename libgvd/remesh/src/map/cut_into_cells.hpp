#pragma once

#include "gvd/remesh.hpp"
#include "gvd/segment.hpp"
#include "map/cell_borders.hpp"

namespace gvd {

/// A surface cut into the cells of its remesh, ready for a one-to-one map.
///
/// Properties: (1) every cell is a disc, and the surface's vertices come first, in their order; (2) between two branch
/// points, a run along another cell has an inner vertex; (3) the border of a cell at the boundary has an anchor inside
/// its run along the boundary: the generator, or the nearest point; (4) inside a cell no edge joins two vertices of
/// that run on the same side of the anchor, itself included.
struct CellSurface {
  CutMesh cut;
  IdVector<GeneratorId, CellBorder> borders;
  IdVector<GeneratorId, VertexId> anchors;  ///< invalid for cells that are not at the boundary
};

/// Cuts along the bisectors, and splits edges for properties (2) to (4).
/// Throws Error{no_valid_result} where the cells are no discs, and what cut_faces throws. Cost: O(n log n).
CellSurface cut_into_cells(const Mesh& surface, const RemeshResult& result);

}  // namespace gvd
