// Growing ends (section 4.3): where the end of a bisector leaves its face, and where two ends intersect.
//
// Inside a face, an end is a ray: along the perpendicular bisector of the images of its two generators in the plane of
// the face, or along the traced segment that it stretches. Its exit and its intersections are therefore those of
// straight lines, and the predicted distance of a point from the generators is the distance from the images.
// Invariant: the left cell lies on the left of the end's direction, so that the cell between two ends is on the right
// of the first end and on the left of the second.
#include "diagram/growth/growing_end.hpp"

#include <algorithm>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"

namespace gvd {
namespace {

/// Largest difference of two distances that count as equal, in multiples of the longest side of the face. The paper
/// names no value. Marched distances are off by a few hundredths of a side.
constexpr double kEquidistance = 0.25;

/// Distances from a point to the left, the middle and the right generator.
std::array<double, 3> distances_at(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  return {(point - first.left_image).norm(),
          0.5 * ((point - first.right_image).norm() + (point - second.left_image).norm()),
          (point - second.right_image).norm()};
}

}  // namespace

std::optional<Exit> find_exit(const GrowingEnd& end, const std::array<Vec2, 3>& corner) {
  const Vec2 direction = end.direction;
  if (!direction.allFinite()) return std::nullopt;
  std::optional<Exit> first;
  double soonest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec2& a = corner[i];
    const Vec2 along = corner[(i + 1) % 3] - a;
    const double outward = cross(direction, along);  // > 0: the ray crosses this edge from inside to outside
    if (!(outward > 0)) continue;
    const double to_edge = std::max(0.0, intersect_lines(end.start, direction, a, along).s);
    if (to_edge >= soonest) continue;
    soonest = to_edge;
    const Vec2 point = end.start + to_edge * direction;
    first =
        Exit{Mesh::halfedge(end.face, i), (point - a).dot(along) / along.squaredNorm(), point, end.distance_at(point)};
  }
  return first;
}

std::optional<Vec2> find_intersection(const GrowingEnd& first, const GrowingEnd& second) {
  if (!first.exit || !second.exit) return std::nullopt;
  const Vec2 d = first.exit->point - first.start, e = second.exit->point - second.start;
  if (!(cross(d, e) > 0)) return std::nullopt;
  const auto [s, t] = intersect_lines(first.start, d, second.start, e);
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::nullopt;
  return first.start + s * d;
}

double branch_distance(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  const auto d = distances_at(first, second, point);
  return (d[0] + d[1] + d[2]) / 3;
}

bool accept_branch(const GrowthInput& input, const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  const auto plane = FaceLayout(input.mesh(), first.face).corner;
  const double longest =
      std::max({(plane[1] - plane[0]).norm(), (plane[2] - plane[1]).norm(), (plane[0] - plane[2]).norm()});
  const double tolerance = kEquidistance * longest;
  const auto d = distances_at(first, second, point);
  const double least = *std::min_element(d.begin(), d.end());
  if (*std::max_element(d.begin(), d.end()) - least > tolerance) return false;
  bool is_nearest = true;
  input.table.for_each(first.face, [&](const TableEntry& entry) {
    const GeneratorId g = entry.generator;
    if (g == first.left || g == first.right || g == second.right) return;
    const Vec2 image = unfold_generator(plane, input.table.corner_distances(entry));
    is_nearest = is_nearest && (point - image).norm() > least - tolerance;
  });
  return is_nearest;
}

}  // namespace gvd
