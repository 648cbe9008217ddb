#pragma once

#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"
#include "repair/cell_tree.hpp"

namespace gvd {

/// Finds short non-contractible loops of cells: round a limb, through a handle, round a hole.
///
/// It works on the mesh cut along the bisectors, where every cell consists of whole faces.
class CellLoops {
 public:
  /// Throws what cut_faces throws. Cost: O(n log n).
  CellLoops(const Mesh& mesh, const Diagram& diagram);
  CellLoops(const CellLoops&) = delete;
  CellLoops& operator=(const CellLoops&) = delete;

  /// Points of the input mesh that divide a short non-contractible loop of the cell into thirds. They are two, since
  /// the generator serves as the third; three where the generator is far from the loop. Empty for a cell that is a
  /// disc. The loop is the shortest one made of two paths of the shortest-path tree and one edge outside of it that no
  /// pruning removes: Erickson and Har-Peled, Optimally cutting a surface into a disk, 2004.
  /// Cost: O(k log k) for a cell of k faces.
  std::vector<SurfacePoint> find(GeneratorId cell);

 private:
  struct Loop {
    std::vector<VertexId> vertices;  ///< closed, without repetition
    double distance = 0;             ///< length of the path from the tree's root to the first vertex
  };

  std::vector<FaceId> faces_of(GeneratorId cell) const;
  VertexId find_root(const std::vector<FaceId>& faces, GeneratorId cell) const;
  std::vector<HalfedgeId> find_loop_edges(const std::vector<FaceId>& faces, GeneratorId cell);
  Loop close_loop(HalfedgeId last) const;
  std::vector<SurfacePoint> divide_into_thirds(const Loop& loop) const;
  SurfacePoint to_input(VertexId from, VertexId to, double t) const;

  bool is_border(HalfedgeId h, GeneratorId cell) const {
    const HalfedgeId twin = cut_.mesh.twin(h);
    return !twin.valid() || !is_in_cell(cut_, twin, cell);
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  CutMesh cut_;
  CellTree tree_;
  std::vector<FaceId> by_label_;              // all faces of the cut mesh, ascending by label
  IdVector<FaceId, std::int32_t> face_node_;  // scratch of find_loop_edges: the node of each face of the cell
};

}  // namespace gvd
