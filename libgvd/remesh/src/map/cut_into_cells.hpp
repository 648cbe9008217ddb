#pragma once

#include <cstddef>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Consecutive halfedges of a cell's border, along one other cell or along the mesh's boundary.
struct BorderRun {
  GeneratorId other;           ///< invalid along the mesh's boundary
  std::size_t begin = 0, end;  ///< indices of the loop; `end` is not included
};

/// The border of a cell that is a disc.
struct CellBorder {
  std::vector<HalfedgeId> loop;  ///< with the cell on their left, counter-clockwise
  std::vector<BorderRun> runs;   ///< in the loop's order; one along the mesh's boundary comes last

  bool at_boundary() const { return !runs.back().other.valid(); }
};

/// The vertices of a run of the border, from its first to its last. Cost: O(k).
std::vector<VertexId> run_vertices(const Mesh& mesh, const CellBorder& border, const BorderRun& run);

/// The borders of the cells of a mesh whose faces have labels from 0 to `cells` - 1.
///
/// Returns Error{no_valid_result} if a face has no label, a cell is not a disc or has only one run, or two cells share
/// several runs. Cost: O(n), and O(k log k) for a cell with k neighbours.
OrError<IdVector<GeneratorId, CellBorder>> trace_cell_borders(const Mesh& mesh,
                                                              const IdVector<FaceId, GeneratorId>& label,
                                                              std::size_t cells);

/// A surface cut into the cells of its remesh, ready for a one-to-one map.
///
/// Properties: (1) every cell is a disc, and the surface's vertices come first, in their order; (2) between two branch
/// points, a run along another cell has an inner vertex; (3) the border of a cell at the boundary has an anchor inside
/// its run along the boundary: the generator, or the point of the run that is nearest to it; (4) inside a cell, no edge
/// joins two vertices of that run that are on the same side of the anchor, or one of them and the anchor.
struct CellSurface {
  CutMesh cut;
  IdVector<GeneratorId, CellBorder> borders;
  IdVector<GeneratorId, VertexId> anchors;  ///< invalid for cells that are not at the boundary
};

/// Cuts along the bisectors, and splits edges for properties (2) to (4). Returns Error{no_valid_result} if the cells
/// are not discs, and the error of try_to_cut_faces. Cost: O(n log n).
OrError<CellSurface> cut_into_cells(const Mesh& surface, const RemeshResult& result, const Progress& progress = {});

}  // namespace gvd
