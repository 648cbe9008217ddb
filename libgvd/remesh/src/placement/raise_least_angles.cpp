#include "placement/raise_least_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gvd/quality.hpp"

namespace gvd {
namespace {

/// Directions in which a vertex tries to move.
constexpr int kDirections = 8;

/// Length of the first steps, relative to the mean edge of the vertex; the next ones are half as long.
constexpr double kFirstStep = 0.2;

/// Gains of less than this, in degrees, are none: a million times the rounding.
constexpr double kLeastGain = 1e-6;

class AngleRaiser {
 public:
  AngleRaiser(const Mesh& mesh, double least_angle)
      : mesh_(mesh), least_angle_(least_angle), positions_(mesh.positions()), faces_of_(positions_.size()) {
    for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
      for (const VertexId v : mesh.vertices(FaceId(i))) faces_of_[v.index()].push_back(FaceId(i));
    }
  }

  /// False if no vertex has moved.
  bool pass(const std::vector<char>& movable) {
    bool has_moved = false;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (movable[v] && smallest_angle(v) < least_angle_) has_moved |= improve(v);
    }
    return has_moved;
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  std::array<Vec3, 3> corners(FaceId f) const {
    const auto& [a, b, c] = mesh_.vertices(f);
    return {positions_[a.index()], positions_[b.index()], positions_[c.index()]};
  }

  std::vector<double> angles(std::size_t v) const {
    std::vector<double> all;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = corners(f);
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
      const auto [a, b, c] = corners(f);
      normal += (b - a).cross(c - a);
      length += ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    length /= static_cast<double>(faces_of_[v].size());
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

  const Mesh& mesh_;
  double least_angle_;
  std::vector<Vec3> positions_;
  std::vector<std::vector<FaceId>> faces_of_;
};

}  // namespace

std::vector<Vec3> raise_least_angles(const Mesh& mesh, const std::vector<char>& movable, double least_angle) {
  AngleRaiser raiser(mesh, least_angle);
  for (int pass = 0; pass < kAnglePasses && raiser.pass(movable); ++pass) {
  }
  return raiser.positions();
}

}  // namespace gvd
