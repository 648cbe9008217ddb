#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// The topology of cells, by which generators are placed: the arcs of the boundary in a cell, its non-contractible
// loops, and the tips that it surrounds.

namespace gvd {

// cell_topology.cpp

/// A maximal connected arc of the mesh's boundary that lies in one cell: between two ends of bisectors, or a whole
/// boundary loop.
struct BoundaryArc {
  /// The interval from parameter `begin` to `end` of a boundary halfedge.
  struct Segment {
    HalfedgeId halfedge;
    double begin = 0;
    double end = 1;
  };
  GeneratorId cell;
  std::vector<Segment> segments;
};

/// The point of the arc with the least Euclidean distance from `to`. Cost: O(segments).
SurfacePoint find_nearest_point(const Mesh& mesh, const BoundaryArc& arc, const Vec3& to);

/// The boundary arcs of all cells, loop by loop in the order of their first halfedge. A loop that no generator reaches
/// has none. Cost: O(k log k) for k boundary edges and ends of bisectors.
std::vector<BoundaryArc> list_boundary_arcs(const Mesh& mesh, const Diagram& diagram);

/// Whether the face of h belongs to the cell.
inline bool is_in_cell(const CutMesh& cut, HalfedgeId h, GeneratorId cell) { return cut.label[Mesh::face(h)] == cell; }

/// Tree of shortest paths along the edges of one cell's faces, by Dijkstra's algorithm.
///
/// Its arrays have the size of the cut mesh and are reused for one cell after another, so that a tree costs no more
/// than its cell.
class CellTree {
 public:
  /// The cut mesh must outlive the tree.
  explicit CellTree(const CutMesh& cut)
      : cut_(cut), distance_(cut.mesh.vertex_count(), kInfinity), parent_(cut.mesh.vertex_count()) {}

  /// Replaces the tree by that of `cell` from `root`, a corner of its faces. Cost: O(k log k) for k faces.
  void grow(VertexId root, GeneratorId cell);

  /// Mesh units; infinity for a vertex that is not in the tree.
  double distance(VertexId v) const { return distance_[v]; }
  bool contains_edge(HalfedgeId h) const {
    const VertexId a = cut_.mesh.from(h), b = cut_.mesh.to(h);
    return parent_[a] == b || parent_[b] == a;
  }
  /// The vertices from v to the root, both included.
  std::vector<VertexId> path_to_root(VertexId v) const {
    std::vector<VertexId> vertices;
    for (; v.valid(); v = parent_[v]) vertices.push_back(v);
    return vertices;
  }

 private:
  const CutMesh& cut_;
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, VertexId> parent_;
  std::vector<VertexId> touched_;  // the vertices whose entries are not the initial ones
};

/// A link of the dual graph of some faces, across the edge of a halfedge. Its nodes are the numbers of two faces.
struct DualLink {
  /// The node beyond the border of the faces.
  static constexpr std::int32_t kOutside = -1;

  HalfedgeId crossed;
  std::array<std::int32_t, 2> nodes;
};

/// Removes faces with a single link, and that link, until there are none. The outside is never removed. Returns the
/// halfedges of the links that remain, in their order. These links are on cycles, or on paths between cycles or
/// borders. Cost: O(faces and links).
std::vector<HalfedgeId> prune_leaves(std::size_t faces, const std::vector<DualLink>& links);

/// Finds short non-contractible loops of cells: round a limb, through a handle, round a hole.
///
/// It works on the mesh cut along the bisectors, where every cell consists of whole faces.
class CellLoops {
 public:
  /// `cut`: the mesh, cut along the diagram's bisectors. Cost: O(n log n).
  CellLoops(const Mesh& mesh, const Diagram& diagram, CutMesh cut);
  CellLoops(const CellLoops&) = delete;
  CellLoops& operator=(const CellLoops&) = delete;

  /// Points of the input mesh that divide a short non-contractible loop of the cell into `parts`: one point less than
  /// `parts`, because the generator serves as another, or `parts` points if the generator is far from the loop. Empty
  /// for a cell that is a disc. The loop is the shortest one that consists of two paths of the shortest-path tree and
  /// one edge outside the tree that pruning does not remove. Source: Erickson and Har-Peled, Optimally cutting a
  /// surface into a disk, 2004. Cost: O(k log k) for a cell of k faces.
  std::vector<SurfacePoint> find(GeneratorId cell, int parts = 3);

  /// The borders of a cell, which are closed curves, each as the points of the input mesh at its corners, without
  /// repetition. An annulus has two. Cost: O(k) for a cell of k faces.
  std::vector<std::vector<SurfacePoint>> borders(GeneratorId cell) const;

 private:
  struct Loop {
    std::vector<VertexId> vertices;  ///< closed, without repetition
    double distance = 0;             ///< length of the path from the tree's root to the first vertex
  };

  std::vector<FaceId> faces_of(GeneratorId cell) const;
  VertexId find_root(const std::vector<FaceId>& faces, GeneratorId cell) const;
  std::vector<HalfedgeId> find_loop_edges(const std::vector<FaceId>& faces, GeneratorId cell);
  Loop close_loop(HalfedgeId last) const;
  std::vector<SurfacePoint> divide(const Loop& loop, int parts) const;
  SurfacePoint to_input(VertexId from, VertexId to, double t) const;

  const Mesh& mesh_;
  const Diagram& diagram_;
  CutMesh cut_;
  CellTree tree_;
  std::vector<FaceId> by_label_;              // all faces of the cut mesh, ascending by label
  IdVector<FaceId, std::int32_t> face_node_;  // scratch of find_loop_edges: the node of each face of the cell
};

// opposite_points.cpp

/// Points that each, as one more generator, cut the cell's way around between two of its borders
/// (`CellLoops::borders`), so that an annulus becomes a disc. None for a cell with a single border. On a limb it is the
/// point opposite the generator, as far along the limb as the generator, so that neither cell surrounds the other.
/// opposite_points.cpp has the proof. Cost: O(n), and two exact fields on the cell's faces for each point.
std::vector<SurfacePoint> find_opposite_points(const Mesh& mesh, const Diagram& diagram, GeneratorId cell,
                                               const std::vector<std::vector<SurfacePoint>>& borders);

// tip_rings.cpp

/// An inner vertex is a tip if its total angle, in radians, is below this. At a larger angle, one generator can't
/// surround the vertex, because its bisector with the vertex does not close.
inline constexpr double kTipAngle = std::numbers::pi;

/// Total angle of the faces round a vertex, radians. Cost: O(degree).
double total_angle(const Mesh& mesh, VertexId v);

/// A tip with a cell round it where the surface is too narrow for three generators.
struct NarrowTip {
  VertexId tip;
  double angle = 0;           ///< total angle, radians
  double least_distance = 0;  ///< from the tip, mesh units: farther away there is room for three generators
};

/// What a refusal says of a narrow tip, with advice.
std::string describe(const Mesh& mesh, const NarrowTip& narrow);

/// Finds generators that divide a cell round a tip.
///
/// On a cone of total angle a, let b < a / 2 be the angle between two generators. The one at distance r from the tip
/// shuts the other one out if the other one is farther from the tip than r / cos(b). Points on the shortest loop round
/// the tip lie just that far, because the loop is a straight line. So each generator there shuts the others out, and
/// repairs would go on forever, each at half the distance of the one before. Three points at the same distance r, at
/// angles of a / 3, do not shut each other out.
class TipRings {
 public:
  /// The mesh and the diagram must outlive the rings. Cost: O(n), and O(m) for each of the m cells that are annuli, and
  /// an exact field if one of them surrounds a tip.
  TipRings(const Mesh& mesh, const Diagram& diagram);

  /// Two points as far from the surrounded tip as the cell's generator is. The three divide the tip's total angle in
  /// parts of at most a half, and lie far apart in space. Empty for a cell that is not an annulus or surrounds no tip,
  /// and also if a straight line from the tip to a point is not the shortest path, because the surface is not a cone
  /// there.
  std::vector<SurfacePoint> find(GeneratorId cell) const;

  /// The tip that the cell surrounds, if there is no room for three generators on the circle round it through the
  /// cell's generator. The circle is then shorter than three times the least distance between generators
  /// (kMinAddedSpacing). Nearer to the tip there is still less room.
  std::optional<NarrowTip> find_narrow_tip(GeneratorId cell) const;

 private:
  struct Polar {
    GeneratorId source;  // the tip, an index of sources_
    Vec2 tangent;        // at the tip
  };
  std::optional<Polar> locate(GeneratorId cell) const;
  std::optional<SurfacePoint> follow(GeneratorId source, const Vec2& tangent) const;
  std::vector<VertexId> find_tips(GeneratorId annulus, const IdVector<GeneratorId, VertexId>& sharpest) const;
  std::vector<std::vector<GeneratorId>> list_sides(GeneratorId annulus) const;

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<GeneratorId, std::vector<VertexId>> tips_;  // that each annulus surrounds, one a side
  std::vector<VertexId> sources_;                      // the tips of all annuli, ascending
  std::optional<ExactField> field_;                    // distances from sources_
};

}  // namespace gvd
