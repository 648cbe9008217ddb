#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Lengths and area of a face, stored together because they are read together.
struct FaceShape {
  std::array<double, 3> length{};  ///< lengths of the halfedges of corners 0, 1 and 2, mesh units
  double twice_area = 0;           ///< square mesh units
};

/// An oriented manifold triangle mesh, with or without boundary, of one or several components.
///
/// A mesh consists of flat arrays and is immutable once built. Halfedge 3 f + i of face f runs from its corner i to its
/// corner i + 1 (modulo 3), so faces, corners and halfedges need no table. Edges are numbered in the order of their
/// first halfedge. Memory: about 100 bytes a face.
///
/// Properties: (1) every face has three different vertices; (2) every edge has one or two faces, which
/// run through it in opposite directions; (3) the faces round a vertex form one fan, closed or open;
/// (4) no vertex is without a face; (5) every coordinate is finite; (6) every edge has a positive length.
/// A mesh that breaks one of them can't be built. For arbitrary input see `build_mesh` in soup.hpp.
class Mesh {
 public:
  Mesh() = default;

  /// Builds the connectivity. Positions are in mesh units.
  /// Throws Error{precondition} that names the first element that breaks a property.
  /// Cost: O(n) time and memory.
  Mesh(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces);

  /// The same, and the error is returned.
  static OrError<Mesh> try_to_build(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces);

  std::int32_t vertex_count() const { return positions_.count(); }
  std::int32_t face_count() const { return faces_.count(); }
  std::int32_t edge_count() const { return edge_halfedge_.count(); }
  std::int32_t halfedge_count() const { return 3 * face_count(); }

  /// All ids, for loops.
  IdRange<VertexId> vertices() const { return positions_.ids(); }
  IdRange<FaceId> faces() const { return faces_.ids(); }
  IdRange<EdgeId> edges() const { return edge_halfedge_.ids(); }
  IdRange<HalfedgeId> halfedges() const { return IdRange<HalfedgeId>(halfedge_count()); }

  const Vec3& position(VertexId v) const { return positions_[v]; }
  const std::vector<Vec3>& positions() const { return positions_.raw(); }
  const std::array<VertexId, 3>& vertices(FaceId f) const { return faces_[f]; }
  /// The corners of all faces: with other positions they give a mesh of the same connectivity.
  const std::vector<std::array<VertexId, 3>>& face_vertices() const { return faces_.raw(); }

  static HalfedgeId halfedge(FaceId f, int corner) { return HalfedgeId(3 * f.value() + corner); }
  /// The halfedges of a face's corners 0, 1 and 2.
  static std::array<HalfedgeId, 3> halfedges(FaceId f) { return {halfedge(f, 0), halfedge(f, 1), halfedge(f, 2)}; }
  static FaceId face(HalfedgeId h) { return FaceId(h.value() / 3); }
  static int corner(HalfedgeId h) { return h.value() % 3; }
  static HalfedgeId next(HalfedgeId h) { return HalfedgeId(corner(h) == 2 ? h.value() - 2 : h.value() + 1); }
  static HalfedgeId previous(HalfedgeId h) { return HalfedgeId(corner(h) == 0 ? h.value() + 2 : h.value() - 1); }

  /// The opposite halfedge in the neighbouring face; invalid on the boundary.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }
  EdgeId edge(HalfedgeId h) const { return halfedge_edge_[h]; }
  VertexId from(HalfedgeId h) const { return faces_[face(h)][corner(h)]; }
  VertexId to(HalfedgeId h) const { return from(next(h)); }
  /// The corner of h's face that h does not touch.
  VertexId opposite(HalfedgeId h) const { return from(previous(h)); }

  /// The edge's first halfedge, whose direction is that of the edge.
  HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e]; }
  /// A halfedge that leaves v. At a boundary vertex it is the boundary halfedge, so that `h = twin(previous(h))`,
  /// repeated until it is invalid, visits every face of v.
  HalfedgeId halfedge(VertexId v) const { return vertex_halfedge_[v]; }

  bool is_boundary(EdgeId e) const { return !twin(halfedge(e)).valid(); }
  bool is_boundary(VertexId v) const { return !twin(halfedge(v)).valid(); }

  /// Edge length in mesh units, > 0.
  double length(EdgeId e) const { return length(halfedge(e)); }
  double length(HalfedgeId h) const { return shape_[face(h)].length[corner(h)]; }
  /// Area in square mesh units, >= 0.
  double area(FaceId f) const { return 0.5 * shape_[f].twice_area; }
  const FaceShape& shape(FaceId f) const { return shape_[f]; }
  /// Arithmetic mean of the edge lengths, in mesh units.
  double mean_edge_length() const { return mean_edge_length_; }
  /// Diagonal of the axis-aligned bounding box, in mesh units.
  double bbox_diagonal() const { return bbox_diagonal_; }
  /// The largest absolute value of a coordinate, in mesh units. The rounding error of positions is proportional to it.
  double largest_coordinate() const { return largest_coordinate_; }

 private:
  friend class MeshEditor;  // splits faces and edges and flips edges of the library's working mesh

  /// Each returns the first broken property that it meets.
  std::optional<Error> build();
  std::optional<Error> link_twins();
  void number_edges();
  std::optional<Error> find_vertex_halfedges();
  std::optional<Error> measure();
  void measure_face(FaceId f);

  IdVector<VertexId, Vec3> positions_;
  IdVector<FaceId, std::array<VertexId, 3>> faces_;
  IdVector<HalfedgeId, HalfedgeId> twin_;
  IdVector<HalfedgeId, EdgeId> halfedge_edge_;
  IdVector<EdgeId, HalfedgeId> edge_halfedge_;
  IdVector<VertexId, HalfedgeId> vertex_halfedge_;
  IdVector<FaceId, FaceShape> shape_;
  double mean_edge_length_ = 0;
  double bbox_diagonal_ = 0;
  double largest_coordinate_ = 0;
};

/// The area of all faces, summed in the order of their ids; square mesh units. Cost: O(n).
double compute_area(const Mesh& mesh);

/// Length of the longest edge, in mesh units; 0 without edges. Cost: O(n).
double longest_edge(const Mesh& mesh);

/// Topology and size of a mesh as a whole.
struct MeshSummary {
  std::int32_t vertices = 0;
  std::int32_t edges = 0;
  std::int32_t faces = 0;
  std::int32_t components = 0;
  std::int32_t boundary_loops = 0;
  std::int32_t euler_characteristic = 0;  ///< vertices - edges + faces, over all components
  double area = 0;                        ///< square mesh units
  double bbox_diagonal = 0;               ///< mesh units
};

/// The summary of a mesh. Cost: O(n).
MeshSummary compute_mesh_summary(const Mesh& mesh);

/// The component of each face, numbered from 0 in the order of their first face. Cost: O(n).
IdVector<FaceId, std::int32_t> compute_face_components(const Mesh& mesh);

}  // namespace gvd
