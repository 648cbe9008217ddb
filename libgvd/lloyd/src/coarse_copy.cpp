// Makes a decimated copy of a mesh.
//
// Large meshes are divided into boxes with about equally many vertices. The insides of the boxes are decimated in
// parallel, and then the remaining mesh is decimated as a whole. Each vertex of the copy is a vertex of the input,
// because collapses keep vertices. A chain of collapses leads from each vertex of the input to a vertex of the copy.
#include "gvd/coarse_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "gvd/error.hpp"
#include "mesh/decimate_part.hpp"
#include "mesh/submesh.hpp"

namespace gvd {
namespace {

/// Number of faces in a part, and the largest number of parts. Meshes with up to as many faces as kWholeParts parts are
/// decimated as a whole.
constexpr std::int32_t kPartFaces = 1 << 15, kMaxParts = 64, kWholeParts = 8;

/// The parts leave this many times the requested faces, so that the last round, which sees the whole mesh, has a
/// choice.
constexpr double kLeftByParts = 2;

/// A default copy has one face for this many faces of the mesh, within the bounds of CopySize, or more if generators
/// need them.
constexpr std::int64_t kMeshFacesPerFace = 10;

constexpr std::string_view kStep = "coarse copy";

/// The faces of each part, in the order of the mesh.
struct Parts {
  std::vector<std::vector<FaceId>> faces;
  IdVector<FaceId, PartPlace> places;
};

Parts cut_into_parts(const Mesh& mesh, std::int32_t count) {
  Parts parts;
  parts.faces.resize(count);
  const KdCut cut(mesh.positions(), count);
  for (const FaceId f : mesh.faces()) {
    const VertexId v = mesh.vertices(f)[0];
    const std::int32_t part = count == 1 ? 0 : cut.box(mesh.position(v), v.index());
    parts.places.push_back({part, static_cast<std::int32_t>(parts.faces[part].size())});
    parts.faces[part].push_back(f);
  }
  return parts;
}

/// The mesh after a round, and the maps between its vertices and the vertices before the round.
struct Round {
  Mesh mesh;
  IdVector<VertexId, VertexId> earlier;  // for each vertex after the round
  IdVector<VertexId, VertexId> later;    // for each vertex before the round
};

/// Builds the mesh of the remaining faces. `later` has the target of each collapsed vertex.
void finish_round(const Mesh& before, std::vector<std::array<VertexId, 3>> faces, Round& round) {
  KeptVertices kept = drop_unused_vertices(std::size_t(before.vertex_count()), faces);
  std::vector<Vec3> positions;
  for (const VertexId v : kept.before) positions.push_back(before.position(v));
  for (const VertexId v : before.vertices()) {
    VertexId last = v;
    while (round.later[last].valid()) last = round.later[last];
    // Shortens the chain for later walks.
    for (VertexId w = v; round.later[w].valid();) w = std::exchange(round.later[w], last);
  }
  for (const VertexId v : before.vertices()) round.later[v] = kept.after[round.later[v].valid() ? round.later[v] : v];
  round.earlier = std::move(kept.before);
  round.mesh = Mesh(std::move(positions), std::move(faces));
}

Round decimate(const Mesh& mesh, double share, std::int32_t part_count, const ParallelChunks& parallel) {
  const Parts parts = cut_into_parts(mesh, part_count);
  std::vector<std::vector<std::array<VertexId, 3>>> left(part_count);
  Round round;
  round.later.assign(mesh.vertex_count(), VertexId());
  const auto decimate_one = [&](std::size_t i, const std::function<void(double)>& report) {
    if (parts.faces[i].empty()) return;
    PartDecimator part(mesh, parts.faces[i], parts.places);
    part.decimate(share, report);
    left[i] = part.faces();
    part.enter_targets(round.later);
  };
  if (part_count == 1) {
    decimate_one(0, [&](double done) { report_progress(parallel.progress(), kStep, done); });
  } else {
    parallel.run(left.size(), {kStep}, [&](std::size_t i) { decimate_one(i, {}); });
  }
  std::vector<std::array<VertexId, 3>> joined;
  for (const auto& part : left) joined.insert(joined.end(), part.begin(), part.end());
  finish_round(mesh, std::move(joined), round);
  return round;
}

void append_round(Round&& round, CoarseCopy& copy) {
  for (VertexId& v : copy.copy_vertex) v = round.later[v];
  for (VertexId& v : round.earlier) v = copy.input_vertex[v];
  copy.input_vertex = std::move(round.earlier);
  copy.mesh = std::move(round.mesh);
}

}  // namespace

std::int64_t default_copy_faces(std::int64_t mesh_faces, std::int64_t generators, const CopySize& size) {
  const std::int64_t by_mesh = std::clamp(mesh_faces / kMeshFacesPerFace, size.least, size.most);
  const std::int64_t faces = std::max(by_mesh, size.per_generator * generators);
  return 2 * faces <= mesh_faces ? faces : 0;
}

CoarseCopy make_coarse_copy(const Mesh& mesh, std::int64_t faces, int threads, const Progress& progress) {
  if (faces < 1) throw Error(ErrorCode::invalid_option, "the copy needs at least one face");
  const ParallelChunks parallel(threads, progress);
  report_progress(progress, kStep, 0);
  const std::int32_t parts =
      mesh.face_count() <= kWholeParts * kPartFaces ? 1 : std::min(kMaxParts, mesh.face_count() / kPartFaces);
  const double share = static_cast<double>(faces) / mesh.face_count();
  Round round = decimate(mesh, parts == 1 ? share : kLeftByParts * share, parts, parallel);
  CoarseCopy copy{std::move(round.mesh), std::move(round.earlier), std::move(round.later)};
  if (parts > 1) {
    append_round(decimate(copy.mesh, static_cast<double>(faces) / copy.mesh.face_count(), 1, parallel), copy);
  }
  return copy;
}

}  // namespace gvd
