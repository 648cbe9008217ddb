// The nearest points of a remesh for the vertices of its surface, among the triangles near the vertex's cell.
#include "map/nearest_points.hpp"

#include <algorithm>
#include <utility>

#include "base/least.hpp"
#include "base/parallel_chunks.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "map/cell_map.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The number of vertices of a chunk. Each vertex takes some tens of searches for a closest point on a triangle.
constexpr std::size_t kVerticesPerChunk = 512;

/// The triangles at a vertex and its neighbours, ascending, and their boundary halfedges.
struct Patch {
  std::vector<FaceId> faces;
  std::vector<HalfedgeId> boundary;
};

Patch collect_patch(const Mesh& mesh, VertexId centre) {
  Patch patch;
  const auto add_star = [&](VertexId v) {
    for_each_outgoing(mesh, v, [&](HalfedgeId h) { patch.faces.push_back(Mesh::face(h)); });
  };
  add_star(centre);
  for_each_neighbour(mesh, centre, [&](VertexId v, HalfedgeId) { add_star(v); });
  std::sort(patch.faces.begin(), patch.faces.end());
  patch.faces.erase(std::unique(patch.faces.begin(), patch.faces.end()), patch.faces.end());
  for (const FaceId f : patch.faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!mesh.twin(h).valid()) patch.boundary.push_back(h);
    }
  }
  return patch;
}

/// The nearest point of the remesh's boundary near its vertex.
SurfacePoint nearest_on_boundary(const Mesh& remesh, const Patch& patch, const Vec3& at) {
  Least<SurfacePoint> nearest;
  for (const HalfedgeId h : patch.boundary) {
    const SurfacePoint found = edge_point(h, std::clamp(foot_on_edge(remesh, h, at), 0.0, 1.0));
    nearest.offer((position(remesh, found) - at).norm(), found);
  }
  return nearest.value;
}

/// The vertex of the remesh for each vertex of the surface where a generator is; invalid at the others.
IdVector<VertexId, VertexId> list_generator_vertices(const Mesh& surface, const RemeshResult& result) {
  IdVector<VertexId, VertexId> at_vertex(result.diagram.vertex_label.size());
  for (const VertexId v : result.mesh.vertices()) {
    const SurfacePoint& generator = result.generators[v.index()];
    const auto corner = std::find(generator.bary.begin(), generator.bary.end(), 1.0) - generator.bary.begin();
    if (corner < 3) at_vertex[surface.vertices(generator.face)[corner]] = v;
  }
  return at_vertex;
}

}  // namespace

IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads,
                                                const Progress& progress) {
  const Mesh& remesh = result.mesh;
  std::vector<Patch> patches;  // per vertex of the remesh
  for (const VertexId v : remesh.vertices()) patches.push_back(collect_patch(remesh, v));
  const IdVector<VertexId, VertexId> at_vertex = list_generator_vertices(surface, result);
  const auto map_vertex = [&](VertexId v) {
    if (at_vertex[v].valid()) return vertex_point(remesh, at_vertex[v]);
    const GeneratorId label = result.diagram.vertex_label[v];
    if (!label.valid()) throw Error(ErrorCode::precondition, "a vertex is in no cell", v.value());
    const Patch& patch = patches[label.index()];
    const Vec3& at = surface.position(v);
    if (surface.is_boundary(v) && !patch.boundary.empty()) return nearest_on_boundary(remesh, patch, at);
    const Vec3 normal = surface_normal(surface, vertex_point(surface, v));
    const SurfacePoint best = find_nearest_facing(remesh, patch.faces, at, normal);
    return make_surface_point(best.face, best.bary);
  };
  const auto chunks = cut_into_chunks(result.diagram.vertex_label.size(), kVerticesPerChunk);
  return IdVector<VertexId, SurfacePoint>(
      ParallelChunks(threads, progress).collect(chunks, {"map"}, [&](const Chunk& chunk) {
        std::vector<SurfacePoint> points;
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) points.push_back(map_vertex(VertexId(i)));
        return points;
      }));
}

}  // namespace gvd
