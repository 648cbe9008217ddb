#include "mesh/repair/project_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/plane.hpp"

namespace gvd {
namespace {

/// Into the unit box round the first corner, so that no product overflows or underflows.
std::vector<Vec3> scale(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions) {
  const Vec3& origin = positions[polygon[0]];
  std::vector<Vec3> space;
  double extent = 0;
  for (const std::int32_t v : polygon) {
    space.push_back(positions[v] - origin);
    extent = std::max(extent, space.back().cwiseAbs().maxCoeff());
  }
  for (Vec3& p : space) p /= extent;
  return space;
}

/// Fills `plane` and `is_on_line`. False where the polygon has no normal and does not lie on a line.
bool project(ProjectedPolygon& polygon) {
  const std::vector<Vec3>& space = polygon.space;
  Vec3 normal = Vec3::Zero();
  Vec3 far = Vec3::Zero();
  double widest = 0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    normal += space[i].cross(space[(i + 1) % space.size()]);
    if (space[i].squaredNorm() > far.squaredNorm()) far = space[i];
  }
  for (const Vec3& p : space) widest = std::max(widest, p.cross(far).norm());
  const bool on_line = widest <= kFlatSine * far.squaredNorm();
  if (!on_line && normal.norm() <= kFlatSine) return false;
  polygon.is_on_line = on_line;
  const Vec3 z = on_line ? far.unitOrthogonal() : Vec3(normal.normalized());
  const Vec3 x = on_line ? Vec3(far.normalized()) : z.unitOrthogonal();
  const Vec3 y = z.cross(x);
  for (const Vec3& p : space) polygon.plane.emplace_back(p.dot(x), on_line ? 0 : p.dot(y));
  return true;
}

bool turns_once(const std::vector<Vec2>& corners) {
  double sum = 0;
  for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
    const Vec2 in = corners[i] - corners[(i + n - 1) % n];
    const Vec2 out = corners[(i + 1) % n] - corners[i];
    sum += std::atan2(cross(in, out), in.dot(out));
  }
  return std::abs(sum - 2 * std::numbers::pi) < 1;
}

}  // namespace

ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions) {
  ProjectedPolygon projected;
  projected.space = scale(polygon, positions);
  projected.turns_once = project(projected) && (projected.is_on_line || turns_once(projected.plane));
  return projected;
}

}  // namespace gvd
