#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "repair/added_generators.hpp"
#include "repair/cell_topology.hpp"

namespace gvd {

/// The point of the bisector's polyline nearest to its middle by arc length. On a closed bisector, it is opposite the
/// first point. Cost: O(points).
SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector);

struct ProposedGenerators {
  std::vector<SurfacePoint> points;
  std::optional<NarrowTip> narrow;  ///< the first tip at which a defect can't be repaired
};

/// New generators that repair defects of the dual.
///
/// | property that fails | new generators                                                                            |
/// | ------------------- | ----------------------------------------------------------------------------------------- |
/// | component_reached   | the component's first vertex                                                              |
/// | cell_is_disc        | round a tip: two more points at the generator's distance from the tip (`TipRings`); else  |
/// |                     | thirds of the cell's shortest non-contractible loop, else as for enough_neighbours        |
/// | one_boundary_arc    | on each boundary arc, the point nearest to the generator; the farthest of these points    |
/// | bisector_has_face   | closed: its point farthest from the two generators; open: the farther of its two ends     |
/// | one_bisector        | the midpoint of that bisector of the pair that is shortest relative to its distance       |
/// | one_branch_point    | that one of the branch points of the same cells that is farthest from its generators      |
/// | enough_neighbours   | the cell's farthest vertex, else the farthest point of its bisectors                      |
/// | the others          | the point of the branch point and its bisectors that is farthest from all generators      |
///
/// A candidate that is too close to a generator along the surface (kMinAddedSpacing) is skipped for the next best one.
/// One call repairs at most one defect of each cell, in the order of `defects`, because the repair often removes the
/// cell's other defects too. There are none at all if the surface around a tip is too narrow, because others would not
/// help. Returns at most `max_count` points, and none if every candidate is too close. Throws Error{interrupted} if
/// `progress`, which hears of each defect, cancels. Cost: O(n log n), and for each defect that of the elements of its
/// cells and of the generators of its component.
ProposedGenerators propose_generators(const Mesh& mesh, const Diagram& diagram, const std::vector<DualDefect>& defects,
                                      std::size_t max_count, const Progress& progress = {});

class DefectRepair;  // propose_generators.cpp

/// Lists candidates for one more generator that divides a cell into discs: opposite points (`find_opposite_points`),
/// then a second point at the generator's distance from a tip, or the point opposite the generator on the shortest
/// loop, then vertices, the farthest from the generator first. Points that are too close are left out, as above.
class DiscCandidates {
 public:
  /// `count` limits the number of points of a cell. Mesh and diagram must outlive this. Cost: O(n).
  DiscCandidates(const Mesh& mesh, const Diagram& diagram, std::size_t count);
  DiscCandidates(const DiscCandidates&) = delete;
  DiscCandidates& operator=(const DiscCandidates&) = delete;
  ~DiscCandidates();

  /// The points of a cell that is not a disc. Cost: O(n), cutting the mesh once, and two exact fields on the cell's
  /// faces for each opposite point.
  std::vector<SurfacePoint> list(GeneratorId cell);

 private:
  AddedGenerators added_;
  std::unique_ptr<DefectRepair> repair_;
};

struct NearbyGenerators {
  std::vector<SurfacePoint> points;
  std::int64_t events = 0;  ///< windows propagated (DiagramReport) to find them
};

/// Finds further generators for the defects near generators that are about to be added to a diagram. These rounds of
/// `propose_generators` on a part of the mesh save rounds on all of it.
///
/// Returns at most `max_count` more generators, and none if the part is more than a quarter of the mesh or can't tell
/// (LocalDual). Flipped triangles are not repaired, because other repairs often remove them. Cost: for each round a
/// diagram of the part.
NearbyGenerators propose_nearby(const Mesh& mesh, const Diagram& diagram, const std::vector<SurfacePoint>& added,
                                std::size_t max_count, const DiagramOptions& options);

}  // namespace gvd
