#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/segment.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Whether the face of h belongs to the cell.
inline bool is_in_cell(const CutMesh& cut, HalfedgeId h, GeneratorId cell) { return cut.label[Mesh::face(h)] == cell; }

/// Tree of shortest paths along the edges of one cell's faces, by Dijkstra's algorithm.
///
/// Its arrays have the size of the cut mesh and serve one cell after another, so a tree costs what its cell holds.
class CellTree {
 public:
  /// The cut mesh must outlive the tree.
  explicit CellTree(const CutMesh& cut);

  /// Replaces the tree by that of `cell` from `root`, a corner of its faces. Cost: O(k log k) for k faces.
  void grow(VertexId root, GeneratorId cell);

  /// Mesh units; infinity for a vertex that is not in the tree.
  double distance(VertexId v) const { return distance_[v]; }
  bool contains_edge(HalfedgeId h) const {
    const VertexId a = cut_.mesh.from(h), b = cut_.mesh.to(h);
    return parent_[a] == b || parent_[b] == a;
  }
  /// The vertices from v to the root, both included.
  std::vector<VertexId> path_to_root(VertexId v) const;

 private:
  void clear();

  const CutMesh& cut_;
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, VertexId> parent_;
  std::vector<VertexId> touched_;  // the vertices whose entries are not the initial ones
};

}  // namespace gvd
