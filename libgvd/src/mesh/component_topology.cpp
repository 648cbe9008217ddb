// Computes the Euler characteristic and the number of boundary loops of each component of a mesh.
//
// Components have no vertex in common, because a vertex of a mesh has a single fan of faces. So each vertex and each
// edge counts for the component of one of its faces.
#include "mesh/component_topology.hpp"

#include "mesh/vertex_ring.hpp"

namespace gvd {

std::vector<ComponentTopology> compute_topologies(const Mesh& mesh, const IdVector<FaceId, std::int32_t>& component) {
  std::vector<ComponentTopology> result;
  const auto of = [&](HalfedgeId h) -> ComponentTopology& {
    const auto c = std::size_t(component[Mesh::face(h)]);
    if (result.size() <= c) result.resize(c + 1);
    return result[c];
  };
  for (const VertexId v : mesh.vertices()) ++of(mesh.halfedge(v)).euler_characteristic;
  for (const EdgeId e : mesh.edges()) --of(mesh.halfedge(e)).euler_characteristic;
  for (const FaceId f : mesh.faces()) ++of(Mesh::halfedge(f, 0)).euler_characteristic;
  for_each_boundary_loop(mesh, [&](HalfedgeId h) { ++of(h).boundary_loops; });
  return result;
}

}  // namespace gvd
