#include "diagram/evaluation/reached_faces.hpp"

#include <algorithm>

namespace gvd {

ReachedFaces::ReachedFaces(const Mesh& mesh, const std::vector<SurfacePoint>& generators)
    : component_(compute_face_components(mesh)) {
  std::int32_t count = 0;
  for (const std::int32_t c : component_) count = std::max(count, c + 1);
  has_generator_.assign(static_cast<std::size_t>(count), 0);
  for (const SurfacePoint& g : generators) has_generator_[component_[g.face]] = 1;
}

}  // namespace gvd
