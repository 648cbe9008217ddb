#include "map/nearest_map.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
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
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(f, corner);
      if (!mesh.twin(h).valid()) patch.boundary.push_back(h);
    }
  }
  return patch;
}

ClosestPoint closest_on_edge(const Mesh& mesh, HalfedgeId h, const Vec3& query) {
  const SurfacePoint point = edge_point(h, std::clamp(foot_on_edge(mesh, h, query), 0.0, 1.0));
  return {point, (position(mesh, point) - query).norm()};
}

class NearestMapper {
 public:
  NearestMapper(const Mesh& surface, const RemeshResult& result) : surface_(surface), result_(result) {
    const auto vertices = result.generators.size();
    for (std::size_t i = 0; i < vertices; ++i) patches_.push_back(collect_patch(result.mesh, VertexId(id(i))));
    for (std::size_t i = 0; i < vertices; ++i) remember(result.generators[i], VertexId(id(i)));
  }

  IdVector<VertexId, SurfacePoint> run(int threads) const {
    const Progress none;
    const ParallelChunks parallel(threads, none);
    const auto chunks = cut_into_chunks(result_.diagram.vertex_label.size(), kVerticesPerChunk);
    return IdVector<VertexId, SurfacePoint>(parallel.collect(chunks, {}, [&](const Chunk& chunk) {
      std::vector<SurfacePoint> points;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) points.push_back(map_vertex(VertexId(id(i))));
      return points;
    }));
  }

 private:
  static std::int64_t id(std::size_t i) { return static_cast<std::int64_t>(i); }

  void remember(const SurfacePoint& generator, VertexId vertex) {
    at_vertex_.resize(result_.diagram.vertex_label.size());
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
    ClosestPoint best{{}, std::numeric_limits<double>::infinity()};
    for (const HalfedgeId h : patch.boundary) {
      const ClosestPoint found = closest_on_edge(result_.mesh, h, surface_.position(v));
      if (found.distance < best.distance) best = found;
    }
    return best.point;
  }

  /// Opposite sheets of a thin part can share a vertex: the normal tells them apart.
  SurfacePoint on_faces(VertexId v, const Patch& patch) const {
    const Vec3 normal = surface_normal(surface_, vertex_point(surface_, v));
    ClosestPoint best;
    std::tuple<bool, double> least(true, std::numeric_limits<double>::infinity());
    for (const FaceId f : patch.faces) {
      const ClosestPoint found = closest_point_on_face(result_.mesh, f, surface_.position(v));
      const std::tuple rank(face_normal(result_.mesh, f).dot(normal) < 0, found.distance);
      if (rank < least) {
        least = rank;
        best = found;
      }
    }
    return make_surface_point(best.point.face, best.point.bary);
  }

  const Mesh& surface_;
  const RemeshResult& result_;
  std::vector<Patch> patches_;              // per vertex of the remesh
  IdVector<VertexId, VertexId> at_vertex_;  // per vertex of the surface: of the remesh; invalid without a generator
};

}  // namespace

IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads) {
  return NearestMapper(surface, result).run(threads);
}

}  // namespace gvd
