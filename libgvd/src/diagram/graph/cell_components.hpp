#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/union_find.hpp"
#include "diagram/graph/face_pieces.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The connected components of every cell, by union-find over the pieces of the crossed faces.
///
/// Vertices far from the bisectors need no look. A vertex of label g, unless it is unsupported, has a neighbour of
/// label g that is nearer to g (see NearestLabels). So a chain of uncrossed edges connects it to the vertex of g. That
/// chain may be missing only near an unsupported vertex, a crossed edge between two vertices of one cell, or a vertex
/// that growth moved. There vertices are unanchored: members of their own, united with their neighbours one by one.
/// Cost: O(k) for k crossings, and 4 bytes a face.
class CellComponents {
 public:
  CellComponents(const WorkingMesh& working, const TracedDiagram& traced);

  /// The number of components of every cell: 1 if it is connected.
  IdVector<GeneratorId, std::int32_t> count_components();

  /// All edges of the faces in islands, which are components without the vertex of their generator; ascending. Empty in
  /// a sound diagram.
  std::vector<EdgeId> island_edges();
  /// The vertices of islands, ascending.
  std::vector<VertexId> island_vertices();

 private:
  /// A member of a set: the vertex of a generator, an unanchored vertex, or a piece of a crossed face.
  struct Member {
    GeneratorId generator;
    FaceId face;  ///< of a piece, or one face at an unanchored vertex; invalid for the vertex of a generator
  };

  std::int32_t add_member(GeneratorId g, FaceId f);
  void find_unanchored_vertices();
  bool is_anchored(VertexId v) const;
  void add_face(FaceId f, std::span<const FaceArc> arcs);
  /// Adds a member for every piece of f, whose crossings are in boundary_; fills in member_of_interval_.
  void add_pieces(FaceId f, std::span<const FaceArc> arcs);
  void unite_unanchored_vertices();
  void unite_across_edges();
  std::int32_t member_of(VertexId v) const;
  /// The piece along label interval `interval` of halfedge h of a crossed face, counted along h.
  std::int32_t piece_along(HalfedgeId h, std::int32_t interval) const;

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  UnionFind sets_;  // of members; 0 .. generators - 1 are the vertices of the generators
  std::vector<Member> members_;
  std::map<VertexId, std::int32_t> unanchored_;   // and their members
  IdVector<FaceId, std::int32_t> crossed_index_;  // number of the face among the crossed ones, or -1
  std::vector<std::int32_t> first_interval_;      // three for every crossed face: where its halfedge begins in
  std::vector<std::int32_t> interval_pieces_;     // the piece along each label interval
  std::vector<BoundaryCrossing> boundary_;        // of the current face
  std::vector<std::int32_t> member_of_interval_;  // of the current face: by boundary crossing before the interval
  WorkingPieces pieces_;                          // of the current face, if they had to be traced
};

}  // namespace gvd
