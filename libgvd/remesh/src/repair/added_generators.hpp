#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Least distance between two generators that are near along the surface (`are_near`), as a fraction of the bounding
/// box's diagonal. Shorter edges can have length zero in programs that work in single precision (1.2e-7).
inline constexpr double kMinAddedSpacing = 1e-6;

/// Whether two points are near each other along the surface: one connected part of the surface within the Euclidean
/// distance `radius` of `a` holds both. Points on the two banks of a slit, or on two sheets that touch, are near in
/// space only. Where the radius is less than the surface's features, this agrees with the geodesic distance.
/// Cost: O(k log k) for k faces within the radius; O(1) where the points are farther apart than that in space.
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius);

/// Generators to be added to a diagram: at most `max_count`, each with a least distance from all others.
class AddedGenerators {
 public:
  /// The mesh must outlive this. Cost: O(n).
  AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count);

  std::size_t size() const { return points_.size(); }
  bool is_full() const { return points_.size() == max_count_; }
  std::vector<SurfacePoint> take() { return std::move(points_); }

  /// Adds the point unless the list is full or a generator is too close (kMinAddedSpacing). Cost: O(generators).
  bool add(const SurfacePoint& point);

  /// Adds the first point that `add` accepts, in descending order of value(point). False where it accepts none.
  template <class Value>
  bool add_best(const std::vector<SurfacePoint>& candidates, Value value) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < candidates.size(); ++i) order.emplace_back(-value(candidates[i]), i);
    std::sort(order.begin(), order.end());
    return std::any_of(order.begin(), order.end(), [&](const auto& entry) { return add(candidates[entry.second]); });
  }

  /// Euclidean distance from the nearest generator of the point's component, those added included; mesh units.
  /// Generators of other components don't count. Nor do those that coincide with the point in space and are not near it
  /// along the surface, as on the two banks of a slit. Infinite where no generator counts. Cost: O(generators).
  double clearance(const SurfacePoint& point) const;

  /// Position of a generator of the diagram.
  const Vec3& position_of(GeneratorId g) const { return positions_[g]; }

  /// Component of every face, as compute_face_components numbers them.
  const IdVector<FaceId, std::int32_t>& component() const { return component_; }

 private:
  void insert(const SurfacePoint& point);

  const Mesh& mesh_;
  double spacing_;  // kMinAddedSpacing in mesh units
  std::size_t max_count_;
  IdVector<FaceId, std::int32_t> component_;
  std::vector<SurfacePoint> all_;  // the diagram's generators, then the added ones
  IdVector<GeneratorId, Vec3> positions_;
  std::vector<SurfacePoint> points_;
};

}  // namespace gvd
