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

/// Vertices of a chunk: each takes some tens of closest points.
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

class NearestMapper {
 public:
  NearestMapper(const Mesh& surface, const RemeshResult& result) : surface_(surface), result_(result) {
    at_vertex_.resize(result.diagram.vertex_label.size());
    for (const VertexId v : result.mesh.vertices()) {
      patches_.push_back(collect_patch(result.mesh, v));
      remember(result.generators[v.index()], v);
    }
  }

  IdVector<VertexId, SurfacePoint> run(int threads, const Progress& progress) const {
    const ParallelChunks parallel(threads, progress);
    const auto chunks = cut_into_chunks(result_.diagram.vertex_label.size(), kVerticesPerChunk);
    return IdVector<VertexId, SurfacePoint>(parallel.collect(chunks, {"map"}, [&](const Chunk& chunk) {
      std::vector<SurfacePoint> points;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) points.push_back(map_vertex(VertexId(i)));
      return points;
    }));
  }

 private:
  void remember(const SurfacePoint& generator, VertexId vertex) {
    const auto corner = std::find(generator.bary.begin(), generator.bary.end(), 1.0) - generator.bary.begin();
    if (corner < 3) at_vertex_[surface_.vertices(generator.face)[corner]] = vertex;
  }

  SurfacePoint map_vertex(VertexId v) const {
    if (at_vertex_[v].valid()) return vertex_point(result_.mesh, at_vertex_[v]);
    const GeneratorId label = result_.diagram.vertex_label[v];
    if (!label.valid()) throw Error(ErrorCode::precondition, "a vertex is in no cell", v.value());
    const Patch& patch = patches_[label.index()];
    return surface_.is_boundary(v) && !patch.boundary.empty() ? on_boundary(v, patch) : on_faces(v, patch);
  }

  SurfacePoint on_boundary(VertexId v, const Patch& patch) const {
    const Vec3& at = surface_.position(v);
    Least<SurfacePoint> nearest;
    for (const HalfedgeId h : patch.boundary) {
      const SurfacePoint found = edge_point(h, std::clamp(foot_on_edge(result_.mesh, h, at), 0.0, 1.0));
      nearest.offer((position(result_.mesh, found) - at).norm(), found);
    }
    return nearest.value;
  }

  SurfacePoint on_faces(VertexId v, const Patch& patch) const {
    const Vec3 normal = surface_normal(surface_, vertex_point(surface_, v));
    const SurfacePoint best = find_nearest_facing(result_.mesh, patch.faces, surface_.position(v), normal);
    return make_surface_point(best.face, best.bary);
  }

  const Mesh& surface_;
  const RemeshResult& result_;
  std::vector<Patch> patches_;              // per vertex of the remesh
  IdVector<VertexId, VertexId> at_vertex_;  // per vertex of the surface: of the remesh; invalid without a generator
};

}  // namespace

IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads,
                                                const Progress& progress) {
  return NearestMapper(surface, result).run(threads, progress);
}

}  // namespace gvd
