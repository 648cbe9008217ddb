#include "repair/added_generators.hpp"

#include <cmath>
#include <limits>

#include "repair/are_near.hpp"

namespace gvd {

AddedGenerators::AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count)
    : mesh_(mesh),
      spacing_(kMinAddedSpacing * mesh.bbox_diagonal()),
      max_count_(max_count),
      component_(compute_face_components(mesh)) {
  for (const SurfacePoint& g : existing) insert(g);
}

bool AddedGenerators::add(const SurfacePoint& point) {
  if (is_full() || !(clearance(point) > spacing_)) return false;
  insert(point);
  points_.push_back(point);
  return true;
}

double AddedGenerators::clearance(const SurfacePoint& point) const {
  const Vec3 at = position(mesh_, point);
  const std::int32_t component = component_[point.face];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (component_[all_[i].face] != component) continue;
    const double squared = (positions_[GeneratorId(i)] - at).squaredNorm();
    if (squared >= least) continue;
    if (squared > spacing_ * spacing_ || are_near(mesh_, point, all_[i], spacing_)) least = squared;
  }
  return std::sqrt(least);
}

void AddedGenerators::insert(const SurfacePoint& point) {
  all_.push_back(point);
  positions_.push_back(position(mesh_, point));
}

}  // namespace gvd
