#pragma once

#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Finds short loops that no cell can contract: round a limb, through a handle, round a hole.
///
/// Works on the mesh cut along the bisectors, where every cell is a surface of whole faces.
class CellLoops {
 public:
  /// Cost: O(n log n).
  CellLoops(const Mesh& mesh, const Diagram& diagram);

  /// Two or three points of the mesh that, with the cell's generator or by themselves, part a loop of the cell in
  /// thirds; empty where every loop can be contracted. The loop is the shortest one out of the tree of shortest paths
  /// along edges from the generator and one more edge (Erickson and Har-Peled, Optimally cutting a surface into a disk,
  /// 2004, for the tree and the edges that are left over). Cost: O(k log k) for a cell of k faces.
  std::vector<SurfacePoint> find(GeneratorId cell);

 private:
  struct Loop {
    std::vector<VertexId> vertices;  ///< closed, without repetition
    double stick = 0;                ///< length of the path from the tree's root to the first vertex
  };

  std::vector<FaceId> faces_of(GeneratorId cell) const;
  VertexId root(const std::vector<FaceId>& faces, GeneratorId cell) const;
  void grow_tree(VertexId root, GeneratorId cell);
  std::vector<HalfedgeId> left_over_edges(const std::vector<FaceId>& faces, GeneratorId cell);
  Loop close_loop(HalfedgeId last) const;
  std::vector<SurfacePoint> part_in_thirds(const Loop& loop, GeneratorId cell) const;
  SurfacePoint input_point(VertexId from, VertexId to, double t) const;

  bool is_inside(HalfedgeId h, GeneratorId cell) const { return cut_.label[Mesh::face(h)] == cell; }
  bool is_border(HalfedgeId h, GeneratorId cell) const {
    return !cut_.mesh.twin(h).valid() || cut_.label[Mesh::face(cut_.mesh.twin(h))] != cell;
  }
  bool is_tree_edge(HalfedgeId h) const {
    const VertexId a = cut_.mesh.from(h), b = cut_.mesh.to(h);
    return parent_[a] == b || parent_[b] == a;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  CutMesh cut_;
  std::vector<FaceId> by_label_;         // all faces of the cut mesh, ascending by label
  IdVector<VertexId, double> distance_;  // of the last tree; infinity outside of it
  IdVector<VertexId, VertexId> parent_;
  std::vector<VertexId> touched_;
  IdVector<FaceId, std::int32_t> face_node_;  // scratch of left_over_edges
};

}  // namespace gvd
