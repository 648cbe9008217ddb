#include "added_generators.hpp"

#include <cmath>
#include <limits>

namespace gvd {

AddedGenerators::AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count)
    : mesh_(mesh), max_count_(max_count), component_(compute_face_components(mesh)) {
  for (const SurfacePoint& g : existing) insert(g);
}

bool AddedGenerators::add(const SurfacePoint& point) {
  const double least = kMinAddedSpacing * mesh_.bbox_diagonal();
  if (is_full() || !(clearance(point) > least)) return false;
  insert(point);
  points_.push_back(point);
  return true;
}

double AddedGenerators::clearance(const SurfacePoint& point) const {
  const Vec3 at = position(mesh_, point);
  const std::int32_t component = component_[point.face];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (generator_component_[i] == component) least = std::min(least, (positions_[i] - at).squaredNorm());
  }
  return std::sqrt(least);
}

void AddedGenerators::insert(const SurfacePoint& point) {
  positions_.push_back(position(mesh_, point));
  generator_component_.push_back(component_[point.face]);
}

}  // namespace gvd
