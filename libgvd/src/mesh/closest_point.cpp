#include "gvd/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/barycentric.hpp"

namespace gvd {
namespace {

struct Candidate {
  Bary bary{1, 0, 0};
  double distance = std::numeric_limits<double>::infinity();
};

void keep_closer(Candidate& best, const Candidate& other) {
  if (other.distance < best.distance) best = other;
}

Candidate closest_on_edge(const std::array<Vec3, 3>& corners, std::size_t from, const Vec3& query) {
  const std::size_t to = (from + 1) % 3;
  const Vec3 along = corners[to] - corners[from];
  const double t = std::clamp(along.dot(query - corners[from]) / along.squaredNorm(), 0.0, 1.0);
  Candidate candidate{{0, 0, 0}, (corners[from] + t * along - query).norm()};
  candidate.bary[from] = 1 - t;
  candidate.bary[to] = t;
  return candidate;
}

/// The foot of the perpendicular if it lies inside the triangle; otherwise a candidate at infinite distance.
Candidate closest_inside(const std::array<Vec3, 3>& corners, const Vec3& query) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double square = normal.squaredNorm();
  Candidate candidate;
  if (!(square > 0)) return candidate;
  Bary bary;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    bary[i] = (c - b).cross(query - b).dot(normal) / square;
    if (!(bary[i] >= 0)) return candidate;
  }
  const double sum = bary[0] + bary[1] + bary[2];
  for (double& b : bary) b /= sum;
  return {bary, (interpolate(bary, corners[0], corners[1], corners[2]) - query).norm()};
}

}  // namespace

ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query) {
  const auto& [a, b, c] = mesh.vertices(f);
  const std::array<Vec3, 3> corners{mesh.position(a), mesh.position(b), mesh.position(c)};
  Candidate best = closest_inside(corners, query);
  for (std::size_t i = 0; i < 3; ++i) keep_closer(best, closest_on_edge(corners, i, query));
  return {make_surface_point(f, best.bary), best.distance};
}

}  // namespace gvd
