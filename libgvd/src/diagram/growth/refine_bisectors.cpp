#include "diagram/growth/refine_bisectors.hpp"

#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported once in so many faces.
constexpr std::size_t kRefineStride = 1 << 12;

}  // namespace

std::vector<CrossingEstimate> refine_bisectors(const GrowthInput& input, const Crossings& crossings,
                                               const Progress& progress) {
  const Mesh& mesh = input.mesh();
  std::vector<CrossingEstimate> estimates;
  std::vector<BoundaryCrossing> boundary;
  const std::vector<FaceId> faces = crossed_faces(mesh, crossings);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (k % kRefineStride == 0) report_progress(progress, steps::kRefinement, double(k) / double(faces.size()));
    const FaceId f = faces[k];
    boundary_crossings(mesh, crossings, f, boundary);
    if (boundary.size() != 2) continue;
    const auto corner = FaceLayout(mesh, f).corner;
    const Vec2 p = unfold_generator(corner, corner_distances(input, f, boundary[0].next));
    const Vec2 q = unfold_generator(corner, corner_distances(input, f, boundary[0].previous));
    for (const BoundaryCrossing& c : boundary) {
      const auto i = static_cast<std::size_t>(c.corner);
      const double t = equidistant_parameter(corner[i], corner[(i + 1) % 3], p, q);
      if (!(t > 0 && t < 1)) continue;
      const bool along = mesh.halfedge(crossings[c.id].edge) == Mesh::halfedge(f, c.corner);
      estimates.push_back({c.id, along ? t : 1 - t});
    }
  }
  return estimates;
}

}  // namespace gvd
