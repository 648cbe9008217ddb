// The certificate of a remesh: what holds for the mesh that is returned.
//
// It is measured on the mesh alone, independently of the algorithm: manifoldness by OpenMesh, topology by counting
// elements for each component, orientation by the surface's normals, intersections by exact tests. Components
// correspond by their generators, and the topology is compared component by component, because the errors of two
// components could cancel in a sum. A failure is not thrown; `first_failure` names it.

// OpenMesh's vectors begin uninitialised, and the warning comes where its templates are instantiated.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "dual/inherited_intersections.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/dual.hpp"
#include "gvd/error.hpp"
#ifdef GVD_WITH_OPENMESH
#include "gvd/openmesh.hpp"
#endif
#include "gvd/remesh_certificate.hpp"
#include "mesh/component_topology.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

#ifdef GVD_WITH_OPENMESH
/// Whether OpenMesh takes the mesh: a test that is independent of the constructor of Mesh.
bool is_manifold(const Mesh& mesh) {
  const auto converted = try_to_openmesh(mesh);
  const auto* const peer = std::get_if<OpenMeshTriMesh>(&converted);
  return peer && std::all_of(peer->vertices_begin(), peer->vertices_end(),
                             [&](const auto v) { return !peer->is_isolated(v) && peer->is_manifold(v); });
}
#else
/// Whether the ring of every vertex has all of its corners. The constructor of Mesh refuses edges of three faces.
bool is_manifold(const Mesh& mesh) {
  IdVector<VertexId, int> corners(mesh.vertex_count(), 0);
  for (const HalfedgeId h : mesh.halfedges()) ++corners[mesh.from(h)];
  for (const VertexId v : mesh.vertices()) for_each_outgoing(mesh, v, [&](HalfedgeId) { --corners[v]; });
  return std::all_of(corners.begin(), corners.end(), [](int left) { return left == 0; });
}
#endif

/// The component of the surface that the generators of each component of the remesh lie on. Empty unless the
/// components correspond one to one.
std::vector<std::int32_t> pair_components(const IdVector<FaceId, std::int32_t>& surface_component, const Mesh& remesh,
                                          const IdVector<FaceId, std::int32_t>& remesh_component,
                                          const std::vector<SurfacePoint>& generators) {
  std::map<std::int32_t, std::int32_t> there, back;
  for (const FaceId f : remesh.faces()) {
    for (const VertexId v : remesh.vertices(f)) {
      const std::int32_t a = remesh_component[f], b = surface_component[generators[v.index()].face];
      if (there.try_emplace(a, b).first->second != b || back.try_emplace(b, a).first->second != a) return {};
    }
  }
  std::vector<std::int32_t> pairs;
  for (const auto& [a, b] : there) pairs.push_back(b);
  return pairs;
}

void compare_components(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                        RemeshCertificate& certificate) {
  const auto surface_component = compute_face_components(surface), remesh_component = compute_face_components(remesh);
  const auto pairs = pair_components(surface_component, remesh, remesh_component, generators);
  certificate.same_components = certificate.input.components == certificate.output.components &&
                                std::ssize(pairs) == certificate.input.components;
  if (!certificate.same_components) return;
  const auto wanted = compute_topologies(surface, surface_component);
  const auto found = compute_topologies(remesh, remesh_component);
  certificate.same_in_each_component = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] != wanted[pairs[i]]) certificate.same_in_each_component = false;
  }
}

}  // namespace

std::string RemeshCertificate::first_failure() const {
  if (!manifold) return "it is not a manifold";
  if (!closed_as_input) return "it has a boundary and the input has none, or the other way round";
  if (!same_components) return "its components are not those of the input";
  if (!same_euler_characteristic) return "its Euler characteristic is not that of the input";
  if (!same_boundary_loops) return "it does not have the boundary loops of the input";
  if (!same_in_each_component) return "a component does not have the topology of its component of the input";
  if (flipped_faces > 0) return fmt::format("faces are flipped: {}", flipped_faces);
  if (unused_generators > 0) return fmt::format("generators are not used: {}", unused_generators);
  const std::int64_t intersections = std::ssize(self_intersections) - inherited_intersections;
  if (intersections > 0 && !intersections_allowed) {
    return fmt::format("pairs of its faces intersect: {}", intersections);
  }
  return {};
}

bool RemeshCertificate::ok() const { return first_failure().empty(); }

RemeshCertificate certify_remesh(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                                 const std::vector<SurfacePoint>& face_points, int threads,
                                 std::int64_t decimated_faces) {
  RemeshCertificate certificate;
  const std::vector<SurfacePoint>& generators = diagram.generators;
  certificate.input = compute_mesh_summary(surface);
  certificate.output = compute_mesh_summary(remesh);
  const MeshSummary &in = certificate.input, &out = certificate.output;
  certificate.manifold = is_manifold(remesh);
  certificate.closed_as_input = (in.boundary_loops == 0) == (out.boundary_loops == 0);
  certificate.same_euler_characteristic = in.euler_characteristic == out.euler_characteristic;
  certificate.same_boundary_loops = in.boundary_loops == out.boundary_loops;
  compare_components(surface, remesh, generators, certificate);
  std::vector<char> used(generators.size(), 0);
  for (const FaceId f : remesh.faces()) {
    for (const VertexId v : remesh.vertices(f)) used[v.index()] = 1;
  }
  certificate.unused_generators = std::count(used.begin(), used.end(), 0);
  certificate.flipped_faces = std::ssize(find_flipped_faces(surface, remesh, generators, face_points));
  certificate.self_intersections = find_self_intersections(remesh, threads);
  if (!certificate.self_intersections.empty()) {
    certificate.inherited_intersections =
        std::ssize(find_inherited_pairs({surface, diagram, remesh, face_points, decimated_faces},
                                        certificate.self_intersections, find_self_intersections(surface, threads)));
  }
  return certificate;
}

}  // namespace gvd
