#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "repair/tip_rings.hpp"

namespace gvd {

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

}  // namespace gvd
