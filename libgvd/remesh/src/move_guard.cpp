// Moves of the vertices of a remesh that leave its triangles valid.
//
// No triangle may flip, get an angle below its bound, or intersect one that it did not intersect at the generators. The
// guard halves the steps of all vertices of wrong triangles until none is wrong. Intersections are looked for last,
// when each triangle is valid by itself, because that test costs most. A triangle that was wrong at the generators is
// not judged.
#include "move_guard.hpp"

#include <algorithm>
#include <utility>

#include "dual/flipped_triangles.hpp"
#include "dual/placed_faces.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/quality.hpp"

namespace gvd {
namespace {

/// The fraction of an angle by which it may shrink even if it is below the bound: a million times the rounding.
constexpr double kAngleSlack = 1e-9;

}  // namespace

Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions) {
  return {std::move(positions), mesh.face_vertices()};
}

MoveGuard::MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                     const std::vector<SurfacePoint>& face_points, const PlacementOptions& options)
    : remesh_(remesh),
      threads_(options.threads),
      progress_(options.progress),
      crossed_before_(find_self_intersections(remesh, threads_, progress_)) {
  normal_ = IdVector<FaceId, Vec3>(normals_at_faces(surface, remesh, generators, face_points));
  for (const FaceId f : remesh.faces()) {
    const auto& [a, b, c] = PlacedFaces(remesh).corners(f);
    // Rounding must not make a triangle that does not move seem worse than before.
    least_angle_.push_back(std::min(options.least_angle, (1 - kAngleSlack) * compute_min_angle(a, b, c)));
  }
}

void MoveGuard::loosen(const std::vector<char>& vertices, double least_angle) {
  for (const FaceId f : remesh_.faces()) {
    const auto& [a, b, c] = remesh_.vertices(f);
    if (!vertices[a.index()] && !vertices[b.index()] && !vertices[c.index()]) continue;
    least_angle_[f] = std::min(least_angle_[f], least_angle);
  }
}

bool MoveGuard::is_bad(FaceId f, const std::vector<Vec3>& positions) const {
  const Triangle triangle = PlacedFaces(remesh_, positions).corners(f);
  return is_flipped(triangle, normal_[f]) || compute_min_angle(triangle[0], triangle[1], triangle[2]) < least_angle_[f];
}

std::vector<FaceId> MoveGuard::find_bad_faces(const std::vector<Vec3>& positions) const {
  std::vector<FaceId> bad;
  for (const FaceId f : remesh_.faces()) {
    if (is_bad(f, positions) && !is_bad(f, remesh_.positions())) bad.push_back(f);
  }
  return bad;
}

std::vector<FaceId> MoveGuard::find_crossed_faces(const std::vector<Vec3>& positions) const {
  // Two faces that have not moved intersect only if they did before.
  std::vector<char> has_moved;
  for (const FaceId f : remesh_.faces()) {
    const bool moves = std::ranges::any_of(remesh_.vertices(f),
                                           [&](VertexId v) { return positions[v.index()] != remesh_.position(v); });
    has_moved.push_back(moves ? 1 : 0);
  }
  std::vector<FaceId> crossed;
  for (const FacePair& pair : find_self_intersections({remesh_, positions}, threads_, progress_, has_moved)) {
    if (std::binary_search(crossed_before_.begin(), crossed_before_.end(), pair)) continue;
    crossed.insert(crossed.end(), {pair.first, pair.second});
  }
  return crossed;
}

std::vector<Vec3> MoveGuard::move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const {
  std::vector<int> halvings(from.size(), 0);
  std::vector<Vec3> positions = to;
  while (true) {
    report_progress(progress_, "placement", 1);
    std::vector<FaceId> wrong = find_bad_faces(positions);
    if (wrong.empty()) wrong = find_crossed_faces(positions);
    if (wrong.empty()) return positions;
    std::vector<char> halve(from.size(), 0);
    for (const FaceId f : wrong) {
      for (const VertexId v : remesh_.vertices(f)) halve[v.index()] = 1;
    }
    for (std::size_t v = 0; v < from.size(); ++v) {
      if (!halve[v]) continue;
      ++halvings[v];
      positions[v] = halvings[v] > kMaxHalvings ? from[v] : Vec3((positions[v] + from[v]) / 2);
    }
  }
}

}  // namespace gvd
