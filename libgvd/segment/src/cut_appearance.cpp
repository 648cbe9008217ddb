// Carries texture coordinates and materials over to a cut mesh.
//
// A face keeps the coordinates at the corners that it shares with its parent. At a vertex added inside a parent,
// coordinates are interpolated in the parent. At a vertex added on an edge, they are interpolated along the edge, from
// the same end in both faces; if each face interpolated by itself, the last bits would differ, and writers would see a
// seam.
// Invariant: two faces that share an edge of the cut mesh agree along it exactly where their parents agree.
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/barycentric.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// The edge between two faces; if there are several, the edge nearest to a point.
EdgeId shared_edge(const Mesh& mesh, FaceId a, FaceId b, const Vec3& point) {
  std::pair nearest(kInfinity, EdgeId());
  for (const HalfedgeId h : Mesh::halfedges(a)) {
    if (!mesh.twin(h).valid() || Mesh::face(mesh.twin(h)) != b) continue;
    const Vec3& from = mesh.position(mesh.from(h));
    const Vec3 along = mesh.position(mesh.to(h)) - from;
    const double distance = (from + nearest_on_segment(from, along, point) * along - point).norm();
    nearest = std::min(nearest, {distance, mesh.edge(h)});
  }
  return nearest.second;
}

/// The edge of the input on which each added vertex lies; invalid for other vertices. Faces of two parents meet at such
/// a vertex.
IdVector<VertexId, EdgeId> find_input_edges(const Mesh& mesh, const CutMesh& cut) {
  IdVector<VertexId, EdgeId> edges(cut.mesh.vertex_count());
  IdVector<VertexId, FaceId> first(cut.mesh.vertex_count());
  for (const FaceId f : cut.mesh.faces()) {
    for (const VertexId v : cut.mesh.vertices(f)) {
      if (v.value() < cut.input_vertices) continue;
      if (!first[v].valid()) first[v] = cut.parent[f];
      if (first[v] != cut.parent[f]) edges[v] = shared_edge(mesh, first[v], cut.parent[f], cut.mesh.position(v));
    }
  }
  return edges;
}

/// The nearest point of an edge, as a point of `face`. Its weights are the same in both faces of the edge.
SurfacePoint nearest_on_edge(const Mesh& mesh, EdgeId e, FaceId face, const Vec3& point) {
  const HalfedgeId first = mesh.halfedge(e), own = Mesh::face(first) == face ? first : mesh.twin(first);
  const Vec3& from = mesh.position(mesh.from(first));
  const double t = nearest_on_segment<Vec3>(from, mesh.position(mesh.to(first)) - from, point);
  SurfacePoint found{face, {0, 0, 0}};
  found.bary[std::size_t(Mesh::corner(own))] = own == first ? 1 - t : t;
  found.bary[std::size_t(Mesh::corner(Mesh::next(own)))] = own == first ? t : 1 - t;
  return found;
}

/// Interpolates in the point's face. At a corner, returns the corner's value bit by bit.
Uv interpolate_texture(const std::vector<Uv>& texture, const SurfacePoint& point) {
  Uv sum{};
  for (int i = 0; i < 3; ++i) {
    const double weight = point.bary[std::size_t(i)];
    const Uv& corner = texture[Mesh::halfedge(point.face, i).index()];
    if (weight == 1) return corner;
    for (std::size_t k = 0; k < 2; ++k) sum[k] += weight * corner[k];
  }
  return sum;
}

/// The texture coordinates of the cut faces' corners, in their order.
std::vector<Uv> carry_texture(const Mesh& mesh, const std::vector<Uv>& texture, const CutMesh& cut) {
  const IdVector<VertexId, EdgeId> edges = find_input_edges(mesh, cut);
  const auto point_in = [&](FaceId parent, VertexId v) -> SurfacePoint {
    const auto& corners = mesh.vertices(parent);
    const auto corner = std::find(corners.begin(), corners.end(), v) - corners.begin();
    if (v.value() < cut.input_vertices && corner < 3) return {parent, kWholeTriangle[std::size_t(corner)]};
    const Vec3& at = cut.mesh.position(v);
    return edges[v].valid() ? nearest_on_edge(mesh, edges[v], parent, at)
                            : closest_point_on_face(mesh, parent, at).point;
  };
  std::vector<Uv> carried;
  carried.reserve(std::size_t(cut.mesh.halfedge_count()));
  for (const FaceId f : cut.mesh.faces()) {
    for (const VertexId v : cut.mesh.vertices(f)) {
      carried.push_back(interpolate_texture(texture, point_in(cut.parent[f], v)));
    }
  }
  return carried;
}

}  // namespace

Appearance carry_to_cut_faces(const Mesh& mesh, const Appearance& appearance, const CutMesh& cut) {
  const auto fits = [&](std::size_t count, std::int32_t expected) {
    return count == 0 || std::cmp_equal(count, expected);
  };
  if (!fits(appearance.texture.size(), mesh.halfedge_count()) || !fits(appearance.material.size(), mesh.face_count()) ||
      cut.input_vertices != mesh.vertex_count()) {
    throw Error(ErrorCode::precondition, "the appearance or the cut mesh belongs to another mesh");
  }
  Appearance carried{{}, {}, appearance.materials, appearance.material_files, appearance.unread};
  if (!appearance.texture.empty()) carried.texture = carry_texture(mesh, appearance.texture, cut);
  if (appearance.material.empty()) return carried;
  for (const FaceId parent : cut.parent) carried.material.push_back(appearance.material[parent.index()]);
  return carried;
}

}  // namespace gvd
