#include "geodesic/windows/departures/departures.hpp"

#include "base/plane.hpp"
#include "geodesic/field/face_layout.hpp"
#include "geodesic/tracing/tangent_fan.hpp"

namespace gvd {
namespace {

/// The tangent angle of a halfedge of the working mesh that leaves the fan's generator.
double tangent_angle(const WorkingMesh& working, const TangentFan& fan, HalfedgeId h) {
  const FaceId face = Mesh::face(h), parent = working.parent(face);
  const FaceLayout layout(working.input(), parent);
  const auto at = [&](std::size_t i) {
    Bary corner{0, 0, 0};
    corner[i] = 1;
    return layout.at(working.is_split(face) ? working.parent_bary(face, corner) : corner);
  };
  const auto from = static_cast<std::size_t>(Mesh::corner(h));
  return fan.angle(parent, at((from + 1) % 3) - at(from));
}

}  // namespace

Departures::Departures(const WorkingMesh& working, const std::vector<SurfacePoint>& generators) {
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const GeneratorId g(i);
    const TangentFan fan(working.input(), generators[i]);
    planes_.push_back({tangent_angle(working, fan, working.mesh().halfedge(working.vertex(g))), fan.scale()});
  }
}

}  // namespace gvd
