#include "geodesic/sampling/sampling_random.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Rounds of drawing points again that fell on others. A mesh that has room needs one round, nearly always none.
constexpr int kMaxRounds = 64;

/// Points to draw again: the later one of each pair that is too close. Straight distance on purpose: it also keeps
/// apart what lies on two sheets that touch.
std::vector<std::size_t> find_crowded(const std::vector<Vec3>& positions, double least) {
  // Sorted along a direction that no ordinary model is perpendicular to; only neighbours in that order can be close.
  const Vec3 direction = Vec3(0.6180339887, 0.3819660113, 0.2360679775).normalized();
  std::vector<std::pair<double, std::size_t>> order(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) order[i] = {direction.dot(positions[i]), i};
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> crowded;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= least; ++k) {
      const auto [earlier, later] = std::minmax(order[i].second, order[k].second);
      if ((positions[earlier] - positions[later]).norm() <= least) crowded.push_back(later);
    }
  }
  std::sort(crowded.begin(), crowded.end());
  crowded.erase(std::unique(crowded.begin(), crowded.end()), crowded.end());
  return crowded;
}

}  // namespace

std::vector<FaceId> list_faces(const Mesh& mesh) {
  std::vector<FaceId> faces(static_cast<std::size_t>(mesh.face_count()));
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = FaceId(static_cast<std::int64_t>(i));
  return faces;
}

double compute_area(const Mesh& mesh) {
  double area = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) area += mesh.area(FaceId(f));
  return area;
}

double require_area(const Mesh& mesh) {
  const double area = compute_area(mesh);
  if (area > 0 && std::isfinite(area)) return area;
  throw Error(ErrorCode::precondition,
              "random points need a surface whose area is finite and not 0; take farthest points, or scale the mesh");
}

AreaSampler::AreaSampler(const Mesh& mesh, std::vector<FaceId> faces) : faces_(std::move(faces)) {
  sums_.reserve(faces_.size() + 1);
  sums_.push_back(0);
  for (const FaceId f : faces_) sums_.push_back(sums_.back() + mesh.area(f));
}

FaceId AreaSampler::draw_face(SeededRandom& random, std::size_t first, std::size_t last) const {
  const double target = sums_[first] + random.real() * (sums_[last] - sums_[first]);
  const auto begin = sums_.begin() + static_cast<std::ptrdiff_t>(first);
  // The first place whose faces up to and with it exceed the target; a face without area never does.
  const auto found = std::upper_bound(begin + 1, sums_.begin() + static_cast<std::ptrdiff_t>(last), target);
  return faces_[first + static_cast<std::size_t>(found - begin) - 1];
}

SurfacePoint AreaSampler::draw_point(SeededRandom& random) const {
  for (;;) {
    const FaceId f = draw_face(random, 0, faces_.size());
    // Uniform in the triangle: Turk, Generating random points in triangles, 1990.
    const double root = std::sqrt(random.real()), along = random.real();
    const std::array<double, 3> bary{1 - root, root * (1 - along), root * along};
    if (*std::min_element(bary.begin(), bary.end()) > kBarycentricSnap) return make_surface_point(f, bary);
  }
}

std::vector<SurfacePoint> sample_random(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  require_area(mesh);
  const AreaSampler sampler(mesh, list_faces(mesh));
  SeededRandom random(seed);
  std::vector<SurfacePoint> points(static_cast<std::size_t>(count));
  std::vector<Vec3> positions(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = sampler.draw_point(random);
    positions[i] = position(mesh, points[i]);
  }
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto crowded = find_crowded(positions, kLeastSpacing * mesh.bbox_diagonal());
    if (crowded.empty()) return points;
    for (const std::size_t i : crowded) {
      points[i] = sampler.draw_point(random);
      positions[i] = position(mesh, points[i]);
    }
  }
  throw Error(ErrorCode::precondition, "the surface is too small beside its bounding box for " + std::to_string(count) +
                                           " different points; ask for fewer, or remove far parts");
}

}  // namespace gvd
