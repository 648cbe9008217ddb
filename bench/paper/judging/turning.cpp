#include "judging/turning.hpp"

#include <algorithm>
#include <cmath>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {
namespace {

/// Shorter steps have no direction: a fraction of the mean edge length.
constexpr double kLeastStep = 1e-9;

/// A straight piece of a bisector, in one face.
struct Step {
  SurfacePoint begin, end;
  Vec3 vector;
};

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

std::vector<Step> take_steps(const Mesh& mesh, const Bisector& bisector) {
  std::vector<Step> steps;
  const std::size_t n = bisector.points.size();
  for (std::size_t i = 0; i + (bisector.closed ? 0 : 1) < n; ++i) {
    const auto view = find_common_view(mesh, bisector.points[i], bisector.points[(i + 1) % n]);
    if (!view) throw Error(ErrorCode::precondition, "consecutive points of a bisector share no face");
    const Vec3 vector = position(mesh, view->second) - position(mesh, view->first);
    if (vector.norm() > kLeastStep * mesh.mean_edge_length()) steps.push_back({view->first, view->second, vector});
  }
  return steps;
}

/// In one face the angle in space; from face to face the difference of the angles with the edge between them.
double turning_angle(const Mesh& mesh, const Step& from, const Step& to) {
  const bool on_edge = from.end.kind() == SurfacePoint::Kind::edge;
  if (from.begin.face == to.begin.face || !on_edge) return angle_between(from.vector, to.vector);
  const HalfedgeId h = halfedge(from.end);
  const Vec3 edge = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  return std::abs(angle_between(from.vector, edge) - angle_between(to.vector, edge));
}

}  // namespace

double sum_turning_angles(const Mesh& mesh, const Diagram& diagram) {
  double sum = 0;
  for (const Bisector& bisector : diagram.bisectors) {
    const std::vector<Step> steps = take_steps(mesh, bisector);
    const std::size_t turns = bisector.closed ? steps.size() : std::max<std::size_t>(steps.size(), 1) - 1;
    for (std::size_t i = 0; i < turns; ++i) sum += turning_angle(mesh, steps[i], steps[(i + 1) % steps.size()]);
  }
  return sum;
}

}  // namespace gvd::paper
