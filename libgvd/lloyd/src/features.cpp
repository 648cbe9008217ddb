// The creases of a mesh, and the curves that they form.
//
// A crease is an edge whose faces meet at an angle. Curves run from corner to corner and hold each crease once; closed
// ones come last.
#include "gvd/features.hpp"

#include <cmath>
#include <numbers>

#include "crease_network.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Unit normal of a face. It is scaled before it is normalized, unlike `face_normal`: squares of tiny sides may vanish.
Vec3 stable_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).stableNormalized();
}

}  // namespace

std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options) {
  if (!(options.angle > 0 && options.angle <= 180)) {
    throw Error(ErrorCode::invalid_option, "the angle of creases must be above 0 and at most 180 degrees");
  }
  const double least_cosine = options.angle == 180 ? -2 : std::cos(options.angle * std::numbers::pi / 180);
  std::vector<EdgeId> creases;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid()) {
      if (options.with_boundary) creases.push_back(e);
      continue;
    }
    const Vec3 here = stable_normal(mesh, Mesh::face(h)), there = stable_normal(mesh, Mesh::face(twin));
    const bool has_area = mesh.area(Mesh::face(h)) > 0 && mesh.area(Mesh::face(twin)) > 0;
    if (has_area && here.dot(there) < least_cosine) creases.push_back(e);
  }
  return creases;
}

SurfacePoint point_on_curve(const Mesh& mesh, const CreaseCurve& curve, std::size_t edge, double distance) {
  return point_on_edge(mesh, curve.edges[edge], curve.vertices[edge], distance);
}

std::vector<CreaseCurve> trace_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double corner_distance) {
  CreaseNetwork network(mesh, creases);
  network.thin_corners(corner_distance);
  return trace_curves(mesh, network, creases);
}

}  // namespace gvd
