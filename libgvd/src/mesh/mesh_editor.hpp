#pragma once

#include <utility>

#include "gvd/mesh.hpp"

namespace gvd {

/// Splits faces and edges and flips edges of a mesh in place. No other code changes a built mesh.
///
/// Faces, edges and vertices that an operation does not touch keep their ids. New elements are appended. A split face
/// or edge passes its id to one of its parts. Every operation costs O(1).
class MeshEditor {
 public:
  explicit MeshEditor(Mesh& mesh) : mesh_(mesh) {}

  /// Makes the mesh a copy of another mesh, and reserves memory for `vertices` more vertices, each with two faces and
  /// three edges.
  void copy(const Mesh& other, std::size_t vertices);

  /// Inserts a vertex v at `position` into f = (a, b, c): f becomes (a, b, v), and (b, c, v) and (c, a, v) are appended
  /// in this order.
  VertexId split_face(FaceId f, const Vec3& position);

  /// Inserts a vertex v at `position` into the edge of h, which runs from a to b. h's face (a, b, c), rotated to begin
  /// at a, becomes (a, v, c), and (v, b, c) is appended; the twin's face (b, a, d) becomes (b, v, d), and (v, a, d) is
  /// appended after it.
  VertexId split_edge(HalfedgeId h, const Vec3& position);

  /// Replaces the diagonal a-b of the quadrilateral a, d, b, c by d-c, where h runs from a to b in (a, b, c) and its
  /// twin lies in (b, a, d): h's face becomes (d, b, c), the twin's (c, a, d). h must have a twin.
  void flip_edge(HalfedgeId h);

 private:
  /// Splits the face of `side`, which runs from p to q, at the new vertex v of its edge. Returns the halfedges p-v and
  /// v-q, which have no twins yet.
  std::pair<HalfedgeId, HalfedgeId> split_side(HalfedgeId side, VertexId v);
  FaceId add_face();
  EdgeId add_edge() { return mesh_.edge_halfedge_.push_back(HalfedgeId()); }
  VertexId add_vertex(const Vec3& position) {
    mesh_.vertex_halfedge_.push_back(HalfedgeId());
    return mesh_.positions_.push_back(position);
  }
  void set_face(FaceId f, VertexId a, VertexId b, VertexId c) {
    mesh_.faces_[f] = {a, b, c};
    mesh_.measure_face(f);
  }
  /// Makes h and t the two halfedges of edge e. On the boundary t is invalid.
  void link(HalfedgeId h, HalfedgeId t, EdgeId e);
  /// Makes h, which leaves v, the halfedge of v, or at a boundary vertex the boundary halfedge that leaves it. This
  /// takes no walk around v: an operation on other faces does not change the boundary halfedge, and after an operation
  /// on its face it is h or, if an edge at v was split, the halfedge before h.
  void set_halfedge(VertexId v, HalfedgeId h);

  Mesh& mesh_;
};

}  // namespace gvd
