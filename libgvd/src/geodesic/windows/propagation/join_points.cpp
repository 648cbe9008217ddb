// The shortest path between two points that are near each other, from distances up to the first radius that is large
// enough.
#include "geodesic/windows/propagation/join_points.hpp"

#include <algorithm>

#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"

namespace gvd {
namespace {

/// The first radius, relative to the distance of the points in space. It is doubled up to the last radius, which is
/// relative to the mesh's diagonal. If even that is too short, as on a long spiral, the search continues without a
/// limit.
constexpr double kFirstRadius = 1.5, kLastRadius = 4;

}  // namespace

// A field costs O(n) for its tables, so the radius is doubled rather than raised in small steps. Most points are joined
// at the first attempt.
std::vector<SurfacePoint> join_points(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  if (find_common_view(mesh, a, b)) return {};
  const double last = kLastRadius * mesh.bbox_diagonal();
  double radius = kFirstRadius * (position(mesh, a) - position(mesh, b)).norm();
  for (;;) {
    const GeodesicPath path = ExactField(mesh, {b}, {.threads = 1, .max_distance = radius}).path(a);
    if (path.complete) return {path.points.begin() + 1, path.points.end() - 1};
    if (radius == kInfinity) {
      throw Error(ErrorCode::precondition,
                  "two points of a curve lie on different components, so no path joins them; split the curve");
    }
    radius = 2 * radius < last && radius > 0 ? 2 * radius : kInfinity;
  }
}

}  // namespace gvd
