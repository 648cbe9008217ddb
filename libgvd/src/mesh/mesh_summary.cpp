#include <algorithm>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_area.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Number of closed chains of boundary halfedges.
std::int32_t count_boundary_loops(const Mesh& mesh) {
  std::vector<char> visited(static_cast<std::size_t>(mesh.halfedge_count()), 0);
  std::int32_t loops = 0;
  for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
    HalfedgeId h(i);
    if (mesh.twin(h).valid() || visited[h.index()]) continue;
    ++loops;
    while (!visited[h.index()]) {
      visited[h.index()] = 1;
      h = next_on_boundary(mesh, h);
    }
  }
  return loops;
}

}  // namespace

IdVector<FaceId, std::int32_t> compute_face_components(const Mesh& mesh) {
  IdVector<FaceId, std::int32_t> component(static_cast<std::size_t>(mesh.face_count()), -1);
  std::int32_t count = 0;
  std::vector<FaceId> stack;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    if (component[FaceId(i)] >= 0) continue;
    component[FaceId(i)] = count;
    stack.push_back(FaceId(i));
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
        if (!twin.valid() || component[Mesh::face(twin)] >= 0) continue;
        component[Mesh::face(twin)] = count;
        stack.push_back(Mesh::face(twin));
      }
    }
    ++count;
  }
  return component;
}

MeshSummary compute_mesh_summary(const Mesh& mesh) {
  MeshSummary summary;
  summary.vertices = mesh.vertex_count();
  summary.edges = mesh.edge_count();
  summary.faces = mesh.face_count();
  for (const std::int32_t c : compute_face_components(mesh)) summary.components = std::max(summary.components, c + 1);
  summary.boundary_loops = count_boundary_loops(mesh);
  summary.euler_characteristic = summary.vertices - summary.edges + summary.faces;
  summary.area = compute_area(mesh);
  summary.bbox_diagonal = mesh.bbox_diagonal();
  return summary;
}

}  // namespace gvd
