#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

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
  std::size_t room() const { return max_count_ - points_.size(); }
  /// Empties the list, but not the set of points that others keep their distance from.
  std::vector<SurfacePoint> take() { return std::exchange(points_, {}); }

  /// Adds the point unless the list is full or a generator is too close (kMinAddedSpacing). Cost: that of `clearance`.
  bool add(const SurfacePoint& point) {
    if (is_full() || !(clearance(point) > spacing_)) return false;
    insert(point);
    points_.push_back(point);
    return true;
  }

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
  /// along the surface, as on the two banks of a slit. Infinite where no generator counts. Cost: O(k) for the k
  /// generators of the component.
  double clearance(const SurfacePoint& point) const;

  /// Position of a generator of the diagram.
  const Vec3& position_of(GeneratorId g) const { return positions_[g]; }

  /// Component of every face, as compute_face_components numbers them.
  const IdVector<FaceId, std::int32_t>& component() const { return component_; }

 private:
  void insert(const SurfacePoint& point) {
    of_component_[component_[point.face]].push_back(all_.push_back(point));
    positions_.push_back(position(mesh_, point));
  }

  const Mesh& mesh_;
  double spacing_;  // kMinAddedSpacing in mesh units
  std::size_t max_count_;
  IdVector<FaceId, std::int32_t> component_;
  std::vector<std::vector<GeneratorId>> of_component_;  // indices of all_, ascending; as many lists as faces
  IdVector<GeneratorId, SurfacePoint> all_;             // the diagram's generators, then the added ones
  IdVector<GeneratorId, Vec3> positions_;
  std::vector<SurfacePoint> points_;
};

/// The numbers of added generators and of defects, by round.
using RepairHistory = std::vector<std::pair<std::int64_t, std::size_t>>;

/// The number of generators that a repair is likely to have to add in all. Adding those of the rounds since the last
/// one with the most defects has removed some; the others are assumed to take as many each. It is at least what the
/// topology needs: three vertices for each component and boundary loop, four for each component of a closed surface.
/// Nothing where the defects get no fewer and the topology needs no more generators than there are. `generators`: how
/// many there are now. `history`: of one round at least.
std::optional<std::int64_t> estimate_added(const MeshSummary& mesh, std::size_t generators,
                                           const RepairHistory& history);

/// What became of the defects until a repair ended at a limit, and what helps: behind "N generators were added in M
/// rounds". That is more generators, or a higher `max_added` where that was the limit. But where as many were added as
/// the default allows, no estimate tells how many are needed, and the defects have grown by more than chance, added
/// ones make it worse. `generators` and `history` as in `estimate_added`; `usual`: the default of `max_added`.
std::string advise_at_limit(const MeshSummary& mesh, std::size_t generators, const RepairHistory& history,
                            bool is_max_added, std::int64_t usual);

/// The farthest vertices of the largest cells from their generators, at most `count`, one in each cell, for generators
/// that no defect asks for. Cost: O(n log n).
std::vector<SurfacePoint> propose_farthest(const Mesh& mesh, const Diagram& diagram, std::size_t count);

}  // namespace gvd
