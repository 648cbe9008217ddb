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

/// The least distance between two generators that are near each other along the surface (`are_near`), as a fraction of
/// the bounding box's diagonal. Shorter edges can have length zero in programs that work in single precision (1.2e-7).
inline constexpr double kMinAddedSpacing = 1e-6;

/// Whether two points are near each other along the surface: one connected part of the surface within the Euclidean
/// distance `radius` of `a` holds both. Points on the two banks of a slit, or on two sheets that touch, are near in
/// space only. If the radius is smaller than the features of the surface, this agrees with the geodesic distance. Cost:
/// O(k log k) for k faces within the radius; O(1) if the points are farther apart than that in space.
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius);

/// Generators to be added to a diagram: at most `max_count`, each with a least distance from all others.
class AddedGenerators {
 public:
  /// The mesh must outlive this. Cost: O(n).
  AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count);

  std::size_t size() const { return points_.size(); }
  bool is_full() const { return points_.size() == max_count_; }
  std::size_t room() const { return max_count_ - points_.size(); }
  /// Takes the list. Later points keep their distance from its points all the same.
  std::vector<SurfacePoint> take() { return std::exchange(points_, {}); }

  /// Adds the point unless the list is full or a generator is too close (kMinAddedSpacing). Cost: that of `clearance`.
  bool add(const SurfacePoint& point) {
    if (is_full() || !(clearance(point) > spacing_)) return false;
    insert(point);
    points_.push_back(point);
    return true;
  }

  /// Adds the first point that `add` accepts, in descending order of value(point). False if it accepts none.
  template <class Value>
  bool add_best(const std::vector<SurfacePoint>& candidates, Value value) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < candidates.size(); ++i) order.emplace_back(-value(candidates[i]), i);
    std::sort(order.begin(), order.end());
    return std::any_of(order.begin(), order.end(), [&](const auto& entry) { return add(candidates[entry.second]); });
  }

  /// The Euclidean distance from the nearest generator of the point's component, added ones included; mesh units.
  /// Generators of other components don't count, and neither do generators that coincide with the point in space but
  /// are not near it along the surface, as on the two banks of a slit. Infinite if no generator counts. Cost: O(k) for
  /// the k generators of the component.
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

/// Estimates how many generators a repair has to add in all. The generators added since the last round with the most
/// defects have removed some of these; each remaining defect is assumed to take as many. The estimate is at least what
/// the topology needs: three vertices for each component and boundary loop, four for each component of a closed
/// surface. Nothing if the defects do not decrease and the topology needs no more generators than there are.
/// `generators` is their present number, and `history` has at least one round.
std::optional<std::int64_t> estimate_added(const MeshSummary& mesh, std::size_t generators,
                                           const RepairHistory& history);

/// The end of a message that begins with "N generators were added in M rounds": how the number of defects changed until
/// a repair ended at a limit, and what to do. The advice is more generators, or a higher `max_added` if that was the
/// limit. But if as many were added as the default allows, there is no estimate, and the defects have grown by more
/// than chance, then added generators make it worse. `generators` and `history` are as for `estimate_added`; `usual` is
/// the default of `max_added`.
std::string advise_at_limit(const MeshSummary& mesh, std::size_t generators, const RepairHistory& history,
                            bool is_max_added, std::int64_t usual);

/// The vertices that are farthest from their generators, at most one for each cell and `count` in all. They become
/// generators that no defect asks for. Cost: O(n log n).
std::vector<SurfacePoint> propose_farthest(const Mesh& mesh, const Diagram& diagram, std::size_t count);

}  // namespace gvd
