#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"

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

/// The dual graph of some faces: a node for each face, a link for each edge that the graph may cross.
class DualGraph {
 public:
  /// The node beyond the border of the faces.
  static constexpr std::int32_t kOutside = -1;

  explicit DualGraph(std::size_t faces) : links_of_(faces) {}

  /// Links two nodes across the edge of a halfedge.
  void add_link(HalfedgeId crossed, std::int32_t from, std::int32_t to);

  /// Removes faces with a single link, and that link, until there are none. The outside is never removed. Returns the
  /// halfedges of the links that remain, in the order of add_link: those on cycles or on paths between two cycles or
  /// borders. Cost: O(faces and links).
  std::vector<HalfedgeId> prune_leaves() const;

 private:
  struct Link {
    HalfedgeId crossed;
    std::array<std::int32_t, 2> nodes;
  };
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> links_of_;  // of every face
};

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
