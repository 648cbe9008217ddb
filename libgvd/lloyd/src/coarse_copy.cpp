// A decimated copy of a mesh, and the ways between the two.
//
// Large meshes are cut into boxes of about as many vertices each. Their insides are decimated at the same time, and
// then what is left as a whole. Each vertex of the copy is one of the input, because
// collapses keep vertices. A chain of collapses leads from each vertex of the input to one of the copy. A point goes
// from one mesh to the other by these vertices: the closest point of the faces that are connected with them near by. No
// search through space could tell two sheets of a thin body apart.
#include "gvd/coarse_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "mesh/decimate_part.hpp"
#include "mesh/find_coincident.hpp"
#include "mesh/submesh.hpp"

namespace gvd {
namespace {

/// Faces of a part, and the number of parts at most. Meshes up to so many faces as eight parts have are decimated as a
/// whole.
constexpr std::int32_t kPartFaces = 1 << 15, kMaxParts = 64, kWholeParts = 8;

/// Faces that parts leave, beside what is asked for: the last round, which sees all faces, then chooses among twice as
/// many.
constexpr double kLeftByParts = 2;

/// Faces of a default copy: this share of the mesh's, and no more unless generators need them (CopySize). With 10 a
/// generator, the energies of 1,000 on the bunny are those without a copy. With 20,000 faces instead of 40,000, that of
/// 50 on the armadillo, cut to 832,000 faces, is .1 % larger.
constexpr std::int64_t kMeshFacesPerFace = 10;

constexpr std::string_view kStep = "coarse copy", kSamplingStep = "sampling";

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

/// A mesh that is left by a round, and where the vertices before it went.
struct Round {
  Mesh mesh;
  IdVector<VertexId, VertexId> earlier;  // per vertex that is left
  IdVector<VertexId, VertexId> later;    // per vertex before the round
};

/// The mesh of the faces that are left. `later` has the target of each vertex that collapsed.
void finish_round(const Mesh& before, std::vector<std::array<VertexId, 3>> faces, Round& round) {
  KeptVertices kept = drop_unused_vertices(std::size_t(before.vertex_count()), faces);
  std::vector<Vec3> positions;
  for (const VertexId v : kept.before) positions.push_back(before.position(v));
  for (const VertexId v : before.vertices()) {
    VertexId last = v;
    while (round.later[last].valid()) last = round.later[last];
    // Shortens the chain for all that follow.
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
  const auto decimate_part = [&](std::size_t i, const std::function<void(double)>& report) {
    if (parts.faces[i].empty()) return;
    PartDecimator part(mesh, parts.faces[i], parts.places);
    part.decimate(share, report);
    left[i] = part.faces();
    part.enter_targets(round.later);
  };
  if (part_count == 1) {
    decimate_part(0, [&](double done) { report_progress(parallel.progress(), kStep, done); });
  } else {
    parallel.run(left.size(), {kStep}, [&](std::size_t i) { decimate_part(i, {}); });
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

/// The point closest to `query` among the faces connected with the vertices within twice its distance from the nearest
/// of them.
SurfacePoint find_closest(const Mesh& mesh, std::span<const VertexId> vertices, const Vec3& query) {
  const auto distance = [&](VertexId v) { return (mesh.position(v) - query).norm(); };
  const VertexId nearest = *std::ranges::min_element(vertices, {}, distance);
  ClosestPoint best{vertex_point(mesh, nearest), distance(nearest)};
  for (const FaceId f : faces_within(mesh, best.point, 2 * distance(nearest))) {
    const ClosestPoint found = closest_point_on_face(mesh, f, query);
    if (found.distance < best.distance) best = found;
  }
  return best.point;
}

/// Points between two reports.
constexpr std::size_t kPointsPerReport = 64;

/// move(point) for each of the points, one after the other.
template <class Move>
std::vector<SurfacePoint> move_points(const std::vector<SurfacePoint>& points, const Progress& progress,
                                      const StepPart& part, const Move& move) {
  std::vector<SurfacePoint> moved;
  for (const SurfacePoint& p : points) {
    if (moved.size() % kPointsPerReport == 0) {
      report_progress(progress, part, static_cast<double>(moved.size()) / static_cast<double>(points.size()));
    }
    moved.push_back(move(p));
  }
  return moved;
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

bool are_apart(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  const std::vector<std::int32_t> first = find_coincident(mesh, points);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (static_cast<std::size_t>(first[i]) != i) return false;
  }
  return true;
}

SurfacePoint to_input(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point) {
  std::vector<VertexId> corners;
  for (const VertexId v : copy.mesh.vertices(point.face)) corners.push_back(copy.input_vertex[v]);
  return find_closest(input, corners, position(copy.mesh, point));
}

SurfacePoint to_copy(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point) {
  std::vector<VertexId> corners;
  for (const VertexId v : input.vertices(point.face)) corners.push_back(copy.copy_vertex[v]);
  return find_closest(copy.mesh, corners, position(input, point));
}

std::vector<SurfacePoint> to_input(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                   const Progress& progress, const StepPart& part) {
  return move_points(points, progress, part, [&](const SurfacePoint& p) { return to_input(input, copy, p); });
}

std::vector<SurfacePoint> to_copy(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                  const Progress& progress, const StepPart& part) {
  return move_points(points, progress, part, [&](const SurfacePoint& p) { return to_copy(input, copy, p); });
}

std::vector<SurfacePoint> sample_on_copy(const Mesh& input, const CoarseCopy& copy, const SamplingOptions& options) {
  const std::vector<SurfacePoint> points =
      to_input(input, copy, sample_generators(copy.mesh, options), options.progress, {kSamplingStep, 1, 1});
  return are_apart(input, points) ? points : sample_generators(input, options);
}

Density to_copy(const Mesh& input, const CoarseCopy& copy, const Density& density) {
  if (density.is_uniform()) return {};
  IdVector<VertexId, double> mass(copy.mesh.vertex_count(), 0), area(copy.mesh.vertex_count(), 0);
  for (const FaceId f : input.faces()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = copy.copy_vertex[input.vertices(f)[i]];
      // Where all faces have no area, the mean is that of the corners.
      const double weight = std::max(input.area(f), std::numeric_limits<double>::min());
      mass[v] += weight * density.corners[f][i];
      area[v] += weight;
    }
  }
  for (const VertexId v : copy.mesh.vertices()) mass[v] /= area[v];
  return make_vertex_density(copy.mesh, mass.raw());
}

}  // namespace gvd
