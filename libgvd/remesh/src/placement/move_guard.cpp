#include "placement/move_guard.hpp"

#include <algorithm>

#include "dual/flipped_triangle.hpp"
#include "gvd/quality.hpp"
#include "placement/with_positions.hpp"

namespace gvd {
namespace {

/// Fraction of an angle by which it may shrink even where it is below the bound: a million times the rounding.
constexpr double kAngleSlack = 1e-9;

}  // namespace

MoveGuard::MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                     const std::vector<SurfacePoint>& face_points, const PlacementOptions& options)
    : remesh_(remesh), threads_(options.threads), crossed_before_(find_self_intersections(remesh, options.threads)) {
  normal_ = IdVector<FaceId, Vec3>(normals_at_faces(surface, remesh, generators, face_points));
  for (std::int32_t i = 0; i < remesh.face_count(); ++i) {
    const auto& [a, b, c] = corners(FaceId(i), remesh.positions());
    // Rounding must not take a triangle that does not move for one that is worse than before.
    least_angle_.push_back(std::min(options.least_angle, (1 - kAngleSlack) * compute_min_angle(a, b, c)));
  }
}

void MoveGuard::loosen(const std::vector<char>& vertices, double least_angle) {
  for (std::int32_t i = 0; i < remesh_.face_count(); ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = remesh_.vertices(f);
    if (!vertices[a.index()] && !vertices[b.index()] && !vertices[c.index()]) continue;
    least_angle_[f] = std::min(least_angle_[f], least_angle);
  }
}

MoveGuard::Corners MoveGuard::corners(FaceId f, const std::vector<Vec3>& positions) const {
  const auto& [a, b, c] = remesh_.vertices(f);
  return {positions[a.index()], positions[b.index()], positions[c.index()]};
}

bool MoveGuard::is_bad(FaceId f, const Corners& at) const {
  return is_flipped(at[0], at[1], at[2], normal_[f]) || compute_min_angle(at[0], at[1], at[2]) < least_angle_[f];
}

std::vector<FaceId> MoveGuard::find_bad_faces(const std::vector<Vec3>& positions) const {
  std::vector<FaceId> bad;
  for (std::int32_t i = 0; i < remesh_.face_count(); ++i) {
    const FaceId f(i);
    if (is_bad(f, corners(f, positions)) && !is_bad(f, corners(f, remesh_.positions()))) bad.push_back(f);
  }
  return bad;
}

std::vector<FaceId> MoveGuard::find_crossed_faces(const std::vector<Vec3>& positions) const {
  std::vector<FaceId> crossed;
  for (const FacePair& pair : find_self_intersections(with_positions(remesh_, positions), threads_)) {
    if (std::binary_search(crossed_before_.begin(), crossed_before_.end(), pair)) continue;
    crossed.insert(crossed.end(), {pair.first, pair.second});
  }
  return crossed;
}

std::vector<Vec3> MoveGuard::move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const {
  std::vector<int> halvings(from.size(), 0);
  std::vector<Vec3> positions = to;
  while (true) {
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
