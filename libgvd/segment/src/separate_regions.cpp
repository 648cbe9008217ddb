// Separates regions along their borders, so that each connected part of a region is a component.
//
// Around each vertex, the faces of a region form one or more fans. The first fan keeps the vertex, and every other fan
// gets a copy of it. Each end of an edge between two regions lies in two fans, so the faces of the edge are separated;
// the faces of other edges are not. The order of the fans depends only on regions and faces: the least region comes
// first, and within a region the least face.
#include <algorithm>
#include <tuple>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/face_regions.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Consecutive faces around a vertex that belong to the same region.
struct Fan {
  std::uint32_t region;  ///< see order_of
  FaceId least;
  std::vector<HalfedgeId> halfedges;  ///< the halfedges that leave the vertex

  bool operator<(const Fan& other) const { return std::tie(region, least) < std::tie(other.region, other.least); }
};

/// Collects the fans of a vertex; the first one keeps the vertex.
void collect_fans(const Mesh& mesh, const FaceRegions& regions, VertexId v, std::vector<Fan>& fans) {
  fans.clear();
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    const FaceId f = Mesh::face(h);
    const std::uint32_t region = order_of(regions[f]);
    if (fans.empty() || fans.back().region != region) fans.push_back({region, f, {}});
    fans.back().least = std::min(fans.back().least, f);
    fans.back().halfedges.push_back(h);
  });
  // The ring of an inner vertex is closed, and may begin within a fan.
  if (fans.size() > 1 && !mesh.is_boundary(v) && fans.front().region == fans.back().region) {
    Fan& first = fans.front();
    first.least = std::min(first.least, fans.back().least);
    first.halfedges.insert(first.halfedges.end(), fans.back().halfedges.begin(), fans.back().halfedges.end());
    fans.pop_back();
  }
  std::sort(fans.begin(), fans.end());
}

}  // namespace

SeparatedMesh separate_regions(const Mesh& mesh, const FaceRegions& regions) {
  if (regions.count() != mesh.face_count()) {
    throw Error(ErrorCode::precondition, "the regions were made for another mesh: the number of faces differs");
  }
  std::vector<Vec3> positions = mesh.positions();
  std::vector<std::array<VertexId, 3>> faces = mesh.face_vertices();
  SeparatedMesh result;
  result.input_vertices = mesh.vertex_count();
  for (const VertexId v : mesh.vertices()) result.input_vertex.push_back(v);
  std::vector<Fan> fans;
  for (const VertexId v : mesh.vertices()) {
    collect_fans(mesh, regions, v, fans);
    for (std::size_t i = 1; i < fans.size(); ++i) {
      positions.push_back(mesh.position(v));
      const VertexId copy = result.input_vertex.push_back(v);
      for (const HalfedgeId h : fans[i].halfedges) faces[Mesh::face(h).index()][std::size_t(Mesh::corner(h))] = copy;
    }
  }
  result.mesh = Mesh(std::move(positions), std::move(faces));
  return result;
}

Diagram restrict_to_input(const SeparatedMesh& separated, Diagram diagram) {
  // Copies come after the vertices of the input. Everything else in a diagram refers to faces, which are the same in
  // both meshes.
  diagram.vertex_label.resize(separated.input_vertices);
  diagram.vertex_distance.resize(separated.input_vertices);
  return diagram;
}

}  // namespace gvd
