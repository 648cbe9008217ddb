// Makes a mesh of some faces of another mesh.
//
// A face is found by binary search in the list of faces, so that the cost depends on the size of the part and not of
// the whole mesh. From each corner that has no vertex yet, all corners of its fan are numbered, counter-clockwise and
// clockwise, until the fan ends.
#include "mesh/submesh.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Renumbers the vertices in ascending order of `order`.
void sort_vertices(const IdVector<VertexId, VertexId>& order, FanFaces& fans) {
  const IdVector<VertexId, VertexId> whole = std::move(fans.whole_vertex);
  std::vector<VertexId> sorted;
  for (const VertexId v : whole.ids()) sorted.push_back(v);
  std::ranges::sort(sorted, {}, [&](VertexId v) { return std::tuple(order[whole[v]], whole[v], v); });
  IdVector<VertexId, VertexId> number(whole.size());
  fans.whole_vertex = {};
  for (const VertexId v : sorted) number[v] = fans.whole_vertex.push_back(whole[v]);
  for (auto& corners : fans.faces) {
    for (VertexId& v : corners) v = number[v];
  }
}

}  // namespace

FanFaces number_fans(const Mesh& mesh, const std::vector<FaceId>& faces) {
  FanFaces fans;
  fans.faces.resize(faces.size());
  const auto find_corner = [&](HalfedgeId h) -> VertexId* {
    if (!h.valid()) return nullptr;
    const auto found = std::ranges::lower_bound(faces, Mesh::face(h));
    if (found == faces.end() || *found != Mesh::face(h)) return nullptr;
    return &fans.faces[std::size_t(found - faces.begin())][std::size_t(Mesh::corner(h))];
  };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const HalfedgeId start : Mesh::halfedges(faces[i])) {
      if (fans.faces[i][std::size_t(Mesh::corner(start))].valid()) continue;
      const VertexId v = fans.whole_vertex.push_back(mesh.from(start));
      const auto number_from = [&](HalfedgeId h, auto next) {
        for (VertexId* corner = find_corner(h); corner && !corner->valid(); corner = find_corner(h)) {
          *corner = v;
          h = next(mesh, h);
        }
      };
      number_from(start, next_outgoing);
      number_from(previous_outgoing(mesh, start), previous_outgoing);
    }
  }
  return fans;
}

std::optional<SurfacePoint> Submesh::to_part(const SurfacePoint& point) const {
  const auto found = std::ranges::lower_bound(whole_face, point.face);
  if (found == whole_face.end() || *found != point.face) return std::nullopt;
  return SurfacePoint{FaceId(found - whole_face.begin()), point.bary};
}

Submesh make_submesh(const Mesh& mesh, std::vector<FaceId> faces, const IdVector<VertexId, VertexId>& order) {
  FanFaces fans = number_fans(mesh, faces);
  if (!order.empty()) sort_vertices(order, fans);
  std::vector<Vec3> positions;
  positions.reserve(fans.whole_vertex.size());
  for (const VertexId v : fans.whole_vertex) positions.push_back(mesh.position(v));
  return {Mesh(std::move(positions), std::move(fans.faces)), IdVector<FaceId, FaceId>(std::move(faces)),
          std::move(fans.whole_vertex)};
}

KeptVertices drop_unused_vertices(std::size_t vertices, std::vector<std::array<VertexId, 3>>& faces) {
  KeptVertices kept;
  kept.after.resize(vertices);
  std::size_t used = 0;
  for (const auto& corners : faces) {
    for (const VertexId v : corners) {
      used += !kept.after[v].valid();
      kept.after[v] = v;
    }
  }
  kept.before.reserve(used);
  for (VertexId& number : kept.after) {
    if (number.valid()) number = kept.before.push_back(number);
  }
  for (auto& corners : faces) {
    for (VertexId& v : corners) v = kept.after[v];
  }
  return kept;
}

}  // namespace gvd
