#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Pieces of faces that are the same in an earlier diagram.
struct KnownPieces {
  IdVector<FaceId, std::uint8_t> is_known;  ///< 1 for faces of the working mesh whose arcs have not changed
  std::vector<FacePiece>& pieces;           ///< pieces of the earlier diagram; those of known faces are moved out of it
};

/// Fills in face labels, pieces and cells. Several threads take part. The bisectors must be in `diagram` already, for
/// the neighbours of cells. `known` is null if all pieces have to be traced. Reports the second half of the step
/// "cells". Cost: O(n).
void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram, KnownPieces* known = nullptr);

/// Fills in the neighbours of the cells, which are the cells with a bisector in common. `collect_cells` calls it;
/// diagrams of other origins may need it, too. Cost: O(b log b) for b bisectors.
void find_neighbours(Diagram& diagram);

/// Counts the boundary loops of every cell, which consist of bisectors and of the mesh's boundary. Cost: O(k) for k
/// arcs and boundary edges.
IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced);

/// The contribution of a subset of the mesh's elements to a cell.
struct CellShare {
  GeneratorId generator;
  std::int32_t euler_characteristic = 0;
  double area = 0;  ///< square mesh units
};

/// The shares of cells in a subset of the mesh, in the order of insertion. Memory and time depend on the cells in the
/// subset, not on the number of generators.
class CellShares {
 public:
  /// The share of cell g, which is added if there is none. The reference is valid until the next call.
  CellShare& operator[](GeneratorId g) {
    if (last_ < shares_.size() && shares_[last_].generator == g) return shares_[last_];
    const auto [known, is_new] = index_.try_emplace(g.value(), shares_.size());
    if (is_new) shares_.push_back({g, 0, 0});
    last_ = known->second;
    return shares_[last_];
  }

  /// All shares, each cell once, in the order of insertion.
  std::vector<CellShare> take() { return std::move(shares_); }

 private:
  std::unordered_map<std::int32_t, std::size_t> index_;  // index of each cell's share
  std::vector<CellShare> shares_;
  std::size_t last_ = 0;  // index of the last call, because most calls ask for the same cell again
};

}  // namespace gvd
