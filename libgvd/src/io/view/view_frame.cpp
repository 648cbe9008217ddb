#include "io/view/view_frame.hpp"

#include <cmath>

namespace gvd::io {

ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes) {
  Vec3 low = scenes.front().mesh->positions().front(), high = low;
  const auto include = [&](const Mesh& mesh) {
    for (const Vec3& p : mesh.positions()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  };
  for (const ViewScene& scene : scenes) {
    include(*scene.mesh);
    if (scene.overlay) include(*scene.overlay->mesh);
  }
  // Halved before they are added: the sum of two large coordinates may overflow.
  const Vec3 half = high / 2 - low / 2;
  const double radius = half.stableNorm();
  return {low / 2 + high / 2, radius > 0 && std::isfinite(radius) ? radius : 1};
}

}  // namespace gvd::io
