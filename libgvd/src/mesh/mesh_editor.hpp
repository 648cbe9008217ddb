#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

/// Splits faces and edges and flips edges of a mesh in place: the only code that changes a built mesh.
///
/// Ids of untouched faces, edges and vertices stay. New faces, edges and vertices are appended; a split face or edge
/// keeps its id for one of its parts. Every operation costs O(1).
class MeshEditor {
 public:
  explicit MeshEditor(Mesh& mesh) : mesh_(mesh) {}

  /// Puts a vertex at `position` inside f = (a, b, c): f becomes (a, b, v); (b, c, v) and (c, a, v) are appended in
  /// this order.
  VertexId split_face(FaceId f, const Vec3& position);

  /// Puts a vertex on the edge of h, from a to b. h's face (a, b, c), rotated to begin at a, becomes (a, v, c), and
  /// (v, b, c) is appended; the twin's face (b, a, d) becomes (b, v, d), and (v, a, d) is appended after it.
  VertexId split_edge(HalfedgeId h, const Vec3& position);

  /// Replaces the diagonal a-b of the quadrilateral a, d, b, c by d-c, where h runs from a to b in (a, b, c) and its
  /// twin lies in (b, a, d): h's face becomes (d, b, c), the twin's (c, a, d). h must have a twin.
  void flip_edge(HalfedgeId h);

 private:
  FaceId add_face();
  EdgeId add_edge();
  VertexId add_vertex(const Vec3& position);
  void set_face(FaceId f, VertexId a, VertexId b, VertexId c);
  /// Makes h and t (may be invalid) the two sides of edge e.
  void glue(HalfedgeId h, HalfedgeId t, EdgeId e);
  /// Points the vertex at halfedge h, or, on the boundary, at the one whose predecessor round the vertex is missing.
  void anchor(VertexId v, HalfedgeId h);

  Mesh& mesh_;
};

}  // namespace gvd
