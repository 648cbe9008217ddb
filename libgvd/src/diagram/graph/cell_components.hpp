#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "base/union_find.hpp"
#include "diagram/graph/face_pieces.hpp"
#include "diagram/graph/traced_diagram.hpp"

namespace gvd {

/// How the pieces of the cut faces hang together with their cells.
///
/// Away from the bisectors nothing has to be looked at: a vertex whose nearest generator is g has a neighbour that is
/// nearer to g (see NearestLabels), so a chain of uncut edges joins it to g's own vertex, its cell's home. Only where
/// that chain may be missing, because a vertex is unsupported, an edge between two vertices of one cell is crossed or
/// growth moved a vertex to another cell, are vertices loose and joined to their neighbours one by one. Cost: O(k) for
/// k crossings, and 4 bytes a face.
class CellComponents {
 public:
  CellComponents(const WorkingMesh& working, const TracedDiagram& traced);

  /// Components of every cell: 1 where it is connected.
  IdVector<GeneratorId, std::int32_t> count_components();

  /// All edges of the faces that hold a component without its own generator's vertex, ascending. Empty in a sound
  /// diagram.
  std::vector<EdgeId> island_edges();
  /// The vertices in such components, ascending.
  std::vector<VertexId> island_vertices();

 private:
  struct Part {
    GeneratorId generator;
    FaceId face;  ///< of a piece, or one face of a loose vertex; invalid for a home
  };

  std::int32_t add_part(GeneratorId g, FaceId f);
  void find_loose_vertices();
  bool is_anchored(VertexId v) const;
  void cut(FaceId f, std::span<const FaceArc> arcs);
  /// A part for every piece of f, whose boundary_ is at hand; fills in piece_of_interval_.
  void number_pieces(FaceId f, std::span<const FaceArc> arcs);
  void join_loose_vertices();
  void join_across_edges();
  std::int32_t part_of(VertexId v) const;
  /// The piece that touches run `run` of halfedge h of a cut face, counted along h.
  std::int32_t piece(HalfedgeId h, std::int32_t run) const;

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  UnionFind sets_;  // parts 0 .. generators - 1 are the homes
  std::vector<Part> parts_;
  std::map<VertexId, std::int32_t> loose_;       // vertices that no chain of uncut edges is known to join to their home
  IdVector<FaceId, std::int32_t> cut_index_;     // place in first_run_ / 3, or -1 for a whole face
  std::vector<std::int32_t> first_run_;          // three for every cut face: where the runs of the halfedge begin in
  std::vector<std::int32_t> run_pieces_;         // the piece at each run
  std::vector<BoundaryCrossing> boundary_;       // of the face at work
  std::vector<std::int32_t> piece_of_interval_;  // and the parts of its runs
  WorkingPieces pieces_;                         // of that face, where they have to be traced
};

}  // namespace gvd
