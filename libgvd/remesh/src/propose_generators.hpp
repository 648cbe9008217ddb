#pragma once

#include <cstddef>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Two generators of a component closer than this part of the bounding box's diagonal are never made: they would give
/// edges that no other program can tell from points of zero length in single precision (1.2e-7).
inline constexpr double kLeastSpacing = 1e-6;

/// Where new generators go, so that the defects go away.
///
/// | property that fails   | new generators                                                                          |
/// | component_reached     | the component's first vertex                                                            |
/// | cell_is_disc          | in thirds round the cell's shortest loop that can't be contracted, else farthest        |
/// | one_boundary_run      | the point nearest to the generator on the run that is farthest from it                  |
/// | bisector_has_face     | closed: the point farthest from its generators; else its end on the boundary that is    |
/// | one_bisector          | the middle of that bisector of the two that is longest for its distance                 |
/// | one_branch_point      | the branch point that is farther from its generators                                    |
/// | enough_neighbours     | the farthest free vertex of the cell, else point of its bisectors                       |
/// | the others            | at the branch point or on its bisectors, the point farthest from all generators         |
///
/// In one call each cell is part of one repaired defect at most, for the others may go away with it; the order is that
/// of `defects`. At most `room` points. Empty where no place is far enough from the component's generators
/// (kLeastSpacing). Cost: O(n log n) where a cell is no disc, else O(n) and O(k m) for k defects and m generators.
std::vector<SurfacePoint> place_generators(const Mesh& mesh, const Diagram& diagram,
                                           const std::vector<DualDefect>& defects, std::size_t room);

}  // namespace gvd
