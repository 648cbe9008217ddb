#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "repair/added_generators.hpp"
#include "repair/tip_rings.hpp"

namespace gvd {

/// Length of the bisector's polyline, mesh units; that of a closed one lacks its last segment. Cost: O(points).
double compute_length(const Mesh& mesh, const Bisector& bisector);

/// The point of the bisector's polyline nearest to the middle of an open bisector, by arc length. Cost: O(points).
SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector);

/// Adds the generators that repair one defect of a dual. The table of propose_generators says where they go. Adds
/// nothing where no candidate is far enough from the other generators.
void repair_defect(const Mesh& mesh, const Diagram& diagram, const DualDefect& defect, AddedGenerators& added);

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
/// | one_boundary_arc    | of each boundary arc of the cell the point nearest to the generator; of these the farthest |
/// | bisector_has_face   | closed: its point farthest from the two generators; open: the farther of its two ends     |
/// | one_bisector        | the midpoint of that bisector of the pair that is shortest relative to its distance       |
/// | one_branch_point    | of the branch points of the same cells the one that is farthest from its generators       |
/// | enough_neighbours   | the cell's farthest vertex, else the farthest point of its bisectors                      |
/// | the others          | of the branch point and its bisectors the point farthest from all generators              |
///
/// A candidate that is too close to a generator along the surface (kMinAddedSpacing) is skipped for the next best one.
/// One call repairs at most one defect of each cell, in the order of `defects`, because the repair often removes the
/// cell's other defects too. None at all where the surface round a tip is too narrow: others would not help.
/// Returns at most `max_count` points; none where every candidate is too close.
/// Cost: O(n log n + k (n + m)) for k defects and m generators, at most.
ProposedGenerators propose_generators(const Mesh& mesh, const Diagram& diagram, const std::vector<DualDefect>& defects,
                                      std::size_t max_count);

/// Repairs what generators that are about to be added to a diagram leave wrong near them, or make wrong. Rounds of
/// `propose_generators` on a part of the mesh save rounds on all of it.
///
/// Returns more generators to add, at most `max_count`. None where the part is more than a quarter of the mesh, or
/// can't tell (LocalDual). Flipped triangles are not repaired: other repairs often remove them.
/// Cost: for each round a diagram of the part.
std::vector<SurfacePoint> propose_nearby(const Mesh& mesh, const Diagram& diagram,
                                         const std::vector<SurfacePoint>& added, std::size_t max_count,
                                         const DiagramOptions& options);

}  // namespace gvd
