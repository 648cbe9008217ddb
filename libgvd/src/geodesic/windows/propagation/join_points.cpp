// The shortest path between two points that are near each other, by distances up to the first radius that reaches.
#include "geodesic/windows/propagation/join_points.hpp"

#include <algorithm>

#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"

namespace gvd {
namespace {

/// The first radius, in distances of the points in space; it is doubled up to the last one, in diagonals of the mesh.
/// On a long spiral the last one may not reach: then there is no limit.
constexpr double kFirstRadius = 1.5, kLastRadius = 4;

}  // namespace

// A field costs O(n) for its tables, so the radius is doubled and not raised by little: most points are joined at once.
std::vector<SurfacePoint> join_points(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  if (find_common_view(mesh, a, b)) return {};
  const double last = kLastRadius * mesh.bbox_diagonal();
  double radius = kFirstRadius * (position(mesh, a) - position(mesh, b)).norm();
  for (;;) {
    const GeodesicPath path = ExactField(mesh, {b}, {.threads = 1, .max_distance = radius}).path(a);
    if (path.complete) return {path.points.begin() + 1, path.points.end() - 1};
    if (radius == kInfinity) {
      throw Error(ErrorCode::precondition, "no path joins two points of a curve: they lie on two components; part it");
    }
    radius = 2 * radius < last && radius > 0 ? 2 * radius : kInfinity;
  }
}

}  // namespace gvd
