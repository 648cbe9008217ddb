#include "diagram/envelope/equidistant_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gvd {
namespace {

/// A place and its distance to a generator, seen from the image of a first source and less that source's offset: on
/// the cone |p| = d.
using OnCone = Vec3;

/// Where the distance to another image is as much longer as its offset is shorter: a plane. |p|^2 = d^2 less
/// |p - image|^2 = (d - offset)^2 is linear.
struct Plane {
  Vec3 normal;
  double level;
  Plane(const Vec2& image, double offset)
      : normal(image.x(), image.y(), -offset), level(0.5 * (image.squaredNorm() - offset * offset)) {}
};

/// Appends the points of the cone on both planes, as places beside the cone's tip.
void append_common_points(const Plane& first, const Plane& second, const Vec2& tip, std::vector<Vec2>& points) {
  const Vec3 normals = first.normal.cross(second.normal);
  const double size = normals.norm();
  if (!(size > 0)) return;
  const Vec3 along = normals / size;
  const OnCone start = (first.level * second.normal - second.level * first.normal).cross(along) / size;
  const auto product = [](const Vec3& u, const Vec3& v) { return u.x() * v.x() + u.y() * v.y() - u.z() * v.z(); };
  // The line start + t along meets |p|^2 = d^2. Rounding can make the discriminant of a double root negative.
  const double a = product(along, along), half = product(start, along), constant = product(start, start);
  const double root = std::sqrt(std::max(0.0, half * half - a * constant));
  const double q = -(half + std::copysign(root, half));
  for (const double t : {q / a, constant / q}) {
    if (std::isfinite(t)) points.push_back(tip + (start + t * along).head<2>());
  }
}

}  // namespace

std::vector<Vec2> equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                                     std::span<const FaceSource> c) {
  std::vector<Vec2> points;
  for (const FaceSource& first : a) {
    for (const FaceSource& second : b) {
      const Plane plane(second.image - first.image, second.offset - first.offset);
      for (const FaceSource& third : c) {
        append_common_points(plane, Plane(third.image - first.image, third.offset - first.offset), first.image, points);
      }
    }
  }
  return points;
}

}  // namespace gvd
