// The length of a bisector, for the figures of diagrams and regions, and for the choice of new generators.
//
// Each point's position is computed once, and segments are added in their order.
#include "diagram/bisector_length.hpp"

#include <cstddef>

#include "gvd/surface_point.hpp"

namespace gvd {

double compute_length(const Mesh& mesh, const Bisector& bisector) {
  const auto& points = bisector.points;
  if (points.empty()) return 0;
  const Vec3 first = position(mesh, points.front());
  Vec3 last = first;
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 next = position(mesh, points[i]);
    length += (next - last).norm();
    last = next;
  }
  return bisector.closed ? length + (first - last).norm() : length;
}

}  // namespace gvd
