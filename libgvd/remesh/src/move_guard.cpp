// Moves that keep the triangles of a remesh valid, and moves that raise its smallest angles.
//
// No triangle may flip, get an angle below its bound, or intersect one that it did not intersect at the generators. The
// guard halves the steps of all vertices of wrong triangles until none is wrong. Intersections are looked for only
// where the triangles are valid one by one: that test costs most. A triangle that was wrong at the generators is not
// judged.
// Source of the raised angles: optimisation-based smoothing (L. Freitag and C. Ollivier-Gooch, Tetrahedral mesh
// improvement using swapping and smoothing, 1997), with a search in place of the linear programs.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "dual/dual_steps.hpp"
#include "gvd/quality.hpp"
#include "placement_steps.hpp"

namespace gvd {

Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions) {
  return {std::move(positions), mesh.face_vertices()};
}

namespace {

/// Fraction of an angle by which it may shrink even where it is below the bound: a million times the rounding.
constexpr double kAngleSlack = 1e-9;

/// Directions in which a vertex tries to move.
constexpr int kDirections = 8;

/// Length of the first steps, relative to the mean edge of the vertex; the next ones are half as long.
constexpr double kFirstStep = 0.2;

/// Gains of less than this, in degrees, are none: a million times the rounding.
constexpr double kLeastGain = 1e-6;

class AngleRaiser {
 public:
  AngleRaiser(const Mesh& mesh, double least_angle)
      : least_angle_(least_angle),
        positions_(mesh.positions()),
        placed_(mesh, positions_),
        faces_of_(positions_.size()) {
    for (const FaceId f : mesh.faces()) {
      for (const VertexId v : mesh.vertices(f)) faces_of_[v.index()].push_back(f);
    }
  }

  /// Passes over the vertices once. False if none has moved.
  bool pass(const std::vector<char>& movable) {
    bool has_moved = false;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (movable[v] && smallest_angle(v) < least_angle_) has_moved |= improve(v);
    }
    return has_moved;
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  std::vector<double> angles(std::size_t v) const {
    std::vector<double> all;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = placed_.corners(f);
      all.push_back(compute_min_angle(a, b, c));
    }
    return all;
  }

  double smallest_angle(std::size_t v) const {
    const std::vector<double> all = angles(v);
    return *std::min_element(all.begin(), all.end());
  }

  /// Whether a triangle gets thinner than it was and than the bound.
  bool thins_another(std::size_t v, double smallest, const std::vector<double>& before) const {
    if (smallest >= least_angle_) return false;
    const std::vector<double> now = angles(v);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] < std::min(before[i], least_angle_)) return true;
    }
    return false;
  }

  /// Two directions along the surface at a vertex, with the length of its faces' mean edge.
  std::array<Vec3, 2> axes(std::size_t v) const {
    Vec3 normal(0, 0, 0);
    double length = 0;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = placed_.corners(f);
      normal += (b - a).cross(c - a);
      length += ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    length /= double(faces_of_[v].size());
    const Vec3 first = normal.unitOrthogonal();
    return {length * first, length * normal.normalized().cross(first)};
  }

  /// Tries places round the vertex, with steps that get shorter, and keeps the best. False if the vertex stays.
  bool improve(std::size_t v) {
    const auto [x, y] = axes(v);
    Vec3 best = positions_[v];
    double best_angle = smallest_angle(v);
    const std::vector<double> before = angles(v);
    bool has_moved = false;
    double step = kFirstStep;
    for (int trial = 0; trial < kAngleTrials; trial += kDirections, step /= 2) {
      const Vec3 from = best;
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        positions_[v] = from + step * (std::cos(turn) * x + std::sin(turn) * y);
        const double angle = smallest_angle(v);
        if (!(angle > best_angle + kLeastGain) || thins_another(v, angle, before)) continue;
        best = positions_[v];
        best_angle = angle;
        has_moved = true;
      }
    }
    positions_[v] = best;
    return has_moved;
  }

  double least_angle_;
  std::vector<Vec3> positions_;
  PlacedFaces placed_;
  std::vector<std::vector<FaceId>> faces_of_;
};

}  // namespace

std::vector<Vec3> raise_least_angles(const Mesh& mesh, const std::vector<char>& movable, double least_angle) {
  AngleRaiser raiser(mesh, least_angle);
  for (int pass = 0; pass < kAnglePasses && raiser.pass(movable); ++pass) {
  }
  return raiser.positions();
}

MoveGuard::MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                     const std::vector<SurfacePoint>& face_points, const PlacementOptions& options)
    : remesh_(remesh), threads_(options.threads), crossed_before_(find_self_intersections(remesh, options.threads)) {
  normal_ = IdVector<FaceId, Vec3>(normals_at_faces(surface, remesh, generators, face_points));
  for (const FaceId f : remesh.faces()) {
    const auto& [a, b, c] = PlacedFaces(remesh).corners(f);
    // Rounding must not take a triangle that does not move for one that is worse than before.
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
  std::vector<FaceId> crossed;
  for (const FacePair& pair : find_self_intersections({remesh_, positions}, threads_)) {
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
