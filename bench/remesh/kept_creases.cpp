#include "kept_creases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gvd/features.hpp"

namespace gvd::bench {
namespace {

struct Segment {
  Vec3 a, b;
};

std::vector<Segment> crease_segments(const Mesh& mesh, double angle) {
  std::vector<Segment> segments;
  for (const EdgeId e : find_creases(mesh, {angle, false})) {
    const HalfedgeId h = mesh.halfedge(e);
    segments.push_back({mesh.position(mesh.from(h)), mesh.position(mesh.to(h))});
  }
  return segments;
}

double squared_distance(const Vec3& p, const Segment& s) {
  const Vec3 along = s.b - s.a;
  const double t = std::clamp((p - s.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (s.a + t * along - p).squaredNorm();
}

}  // namespace

double percent_of_creases_kept(const Mesh& input, const Mesh& remesh, const KeptCreaseOptions& options) {
  const std::vector<Segment> candidates = crease_segments(remesh, options.angle);
  const double reach = std::pow(options.distance * input.bbox_diagonal(), 2);
  const double least_cosine = std::cos(options.direction * std::numbers::pi / 180);
  double all = 0, kept = 0;
  for (const Segment& edge : crease_segments(input, options.angle)) {
    const Vec3 middle = 0.5 * (edge.a + edge.b), direction = (edge.b - edge.a).normalized();
    const double length = (edge.b - edge.a).norm();
    all += length;
    const bool is_kept = std::any_of(candidates.begin(), candidates.end(), [&](const Segment& other) {
      return squared_distance(middle, other) <= reach &&
             std::abs((other.b - other.a).normalized().dot(direction)) >= least_cosine;
    });
    if (is_kept) kept += length;
  }
  return all > 0 ? 100 * kept / all : 100;
}

}  // namespace gvd::bench
