// Texture coordinates and materials on a cut mesh.
//
// A face keeps the coordinates at the corners that it has in common with its parent. A vertex that was added inside a
// parent takes what is linear in the parent. One on an edge takes what is linear along the edge, from the same end in
// both faces: interpolated in each face, the last bits would differ, and writers would see a seam.
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

class CutTexture {
 public:
  CutTexture(const Mesh& mesh, const std::vector<Uv>& texture, const CutMesh& cut)
      : mesh_(mesh), texture_(texture), cut_(cut), edge_(cut.mesh.vertex_count()) {
    find_edges();
  }

  /// In the order of the cut faces' corners.
  std::vector<Uv> run() const {
    std::vector<Uv> carried;
    carried.reserve(std::size_t(cut_.mesh.halfedge_count()));
    for (const FaceId f : cut_.mesh.faces()) {
      for (const VertexId v : cut_.mesh.vertices(f)) carried.push_back(interpolate(point_in(cut_.parent[f], v)));
    }
    return carried;
  }

 private:
  /// Finds the edges of added vertices: faces of two parents meet there.
  void find_edges() {
    IdVector<VertexId, FaceId> first(cut_.mesh.vertex_count());
    for (const FaceId f : cut_.mesh.faces()) {
      for (const VertexId v : cut_.mesh.vertices(f)) {
        if (v.value() < cut_.input_vertices) continue;
        if (!first[v].valid()) first[v] = cut_.parent[f];
        if (first[v] != cut_.parent[f]) edge_[v] = shared_edge(first[v], cut_.parent[f], cut_.mesh.position(v));
      }
    }
  }

  /// Of the edges between two faces the one that is nearest to a point.
  EdgeId shared_edge(FaceId a, FaceId b, const Vec3& point) const {
    std::pair nearest(kInfinity, EdgeId());
    for (const HalfedgeId h : Mesh::halfedges(a)) {
      if (!mesh_.twin(h).valid() || Mesh::face(mesh_.twin(h)) != b) continue;
      const Vec3& from = mesh_.position(mesh_.from(h));
      const Vec3 along = mesh_.position(mesh_.to(h)) - from;
      const double distance = (from + nearest_on_segment(from, along, point) * along - point).norm();
      nearest = std::min(nearest, {distance, mesh_.edge(h)});
    }
    return nearest.second;
  }

  /// The nearest point of an edge, seen from either face with the same weights.
  SurfacePoint nearest_on_edge(EdgeId e, FaceId face, const Vec3& point) const {
    const HalfedgeId first = mesh_.halfedge(e), own = Mesh::face(first) == face ? first : mesh_.twin(first);
    const Vec3& from = mesh_.position(mesh_.from(first));
    const double t = nearest_on_segment<Vec3>(from, mesh_.position(mesh_.to(first)) - from, point);
    SurfacePoint found{face, {0, 0, 0}};
    found.bary[std::size_t(Mesh::corner(own))] = own == first ? 1 - t : t;
    found.bary[std::size_t(Mesh::corner(Mesh::next(own)))] = own == first ? t : 1 - t;
    return found;
  }

  /// A vertex of the cut mesh as a point of its parent.
  SurfacePoint point_in(FaceId parent, VertexId v) const {
    const auto& corners = mesh_.vertices(parent);
    const auto corner = std::find(corners.begin(), corners.end(), v) - corners.begin();
    if (v.value() < cut_.input_vertices && corner < 3) return {parent, kWholeTriangle[std::size_t(corner)]};
    const Vec3& point = cut_.mesh.position(v);
    return edge_[v].valid() ? nearest_on_edge(edge_[v], parent, point)
                            : closest_point_on_face(mesh_, parent, point).point;
  }

  /// Linear in the point's face; at a corner its own value, bit by bit.
  Uv interpolate(const SurfacePoint& point) const {
    Uv sum{};
    for (int i = 0; i < 3; ++i) {
      const double weight = point.bary[std::size_t(i)];
      const Uv& corner = texture_[Mesh::halfedge(point.face, i).index()];
      if (weight == 1) return corner;
      for (std::size_t k = 0; k < 2; ++k) sum[k] += weight * corner[k];
    }
    return sum;
  }

  const Mesh& mesh_;
  const std::vector<Uv>& texture_;
  const CutMesh& cut_;
  IdVector<VertexId, EdgeId> edge_;  // of the input, on which an added vertex lies; invalid for others
};

}  // namespace

Appearance carry_to_cut_faces(const Mesh& mesh, const Appearance& appearance, const CutMesh& cut) {
  const auto fits = [&](std::size_t count, std::int32_t expected) {
    return count == 0 || std::cmp_equal(count, expected);
  };
  if (!fits(appearance.texture.size(), mesh.halfedge_count()) || !fits(appearance.material.size(), mesh.face_count()) ||
      cut.input_vertices != mesh.vertex_count()) {
    throw Error(ErrorCode::precondition, "the appearance or the cut mesh is of another mesh");
  }
  Appearance carried{{}, {}, appearance.materials, appearance.material_files, appearance.unread};
  if (!appearance.texture.empty()) carried.texture = CutTexture(mesh, appearance.texture, cut).run();
  if (appearance.material.empty()) return carried;
  for (const FaceId parent : cut.parent) carried.material.push_back(appearance.material[parent.index()]);
  return carried;
}

}  // namespace gvd
