#include "diagram/envelope/equidistant_points.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/roots.hpp"

namespace gvd {
namespace {

/// A point p with its distance d to a generator, relative to the image of a first source and its offset: a point of the
/// cone |p| = d.
using OnCone = Vec3;

/// The points whose distance to a second image differs from d by the difference of the offsets. They form a plane,
/// because |p|^2 = d^2 minus |p - image|^2 = (d - offset)^2 is linear.
struct Plane {
  Vec3 normal;
  double level;
  Plane(const Vec2& image, double offset)
      : normal(image.x(), image.y(), -offset), level(0.5 * (image.squaredNorm() - offset * offset)) {}
};

/// Appends the points of the cone that lie on both planes. `tip`: the cone's tip in the face.
void append_common_points(const Plane& first, const Plane& second, const Vec2& tip, std::vector<Vec2>& points) {
  const Vec3 normals = first.normal.cross(second.normal);
  const double size = normals.norm();
  if (!(size > 0)) return;
  const Vec3 along = normals / size;
  const OnCone start = (first.level * second.normal - second.level * first.normal).cross(along) / size;
  const auto product = [](const Vec3& u, const Vec3& v) { return u.x() * v.x() + u.y() * v.y() - u.z() * v.z(); };
  // The common line of the planes is start + t along; it intersects |p|^2 = d^2 in the roots.
  for (const double t : quadratic_roots(product(along, along), product(start, along), product(start, start))) {
    if (std::isfinite(t)) points.push_back(tip + (start + t * along).head<2>());
  }
}

}  // namespace

void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points) {
  for (const FaceSource& first : a) {
    for (const FaceSource& second : b) {
      const Plane plane(second.image - first.image, second.offset - first.offset);
      for (const FaceSource& third : c) {
        append_common_points(plane, Plane(third.image - first.image, third.offset - first.offset), first.image, points);
      }
    }
  }
}

}  // namespace gvd
