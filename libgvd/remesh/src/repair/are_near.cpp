#include "repair/are_near.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "gvd/closest_point.hpp"

namespace gvd {
namespace {

/// Euclidean distance of a point from an edge.
double distance_to_edge(const Mesh& mesh, HalfedgeId h, const Vec3& point) {
  const Vec3 &from = mesh.position(mesh.from(h)), along = mesh.position(mesh.to(h)) - from;
  return (from + std::clamp(foot_on_edge(mesh, h, point), 0.0, 1.0) * along - point).norm();
}

}  // namespace

bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius) {
  const Vec3 centre = position(mesh, a);
  if (!((position(mesh, b) - centre).norm() <= radius)) return false;
  const std::vector<FaceId> goal = faces_around(mesh, b);
  std::vector<FaceId> open = faces_around(mesh, a);
  std::set<FaceId> seen(open.begin(), open.end());
  while (!open.empty()) {
    const FaceId f = open.back();
    open.pop_back();
    if (std::find(goal.begin(), goal.end(), f) != goal.end()) return true;
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(f, corner), twin = mesh.twin(h);
      if (!twin.valid() || distance_to_edge(mesh, h, centre) > radius) continue;
      if (seen.insert(Mesh::face(twin)).second) open.push_back(Mesh::face(twin));
    }
  }
  return false;
}

}  // namespace gvd
