#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// A triangle counts as having no area if its height is at most this fraction of its longest side. Dimensionless; about
/// ten times the rounding error of a position on the side.
inline constexpr double kHeightWithoutArea = 1e-15;

/// Flips faces so that each component has the orientation of the majority of its faces. Updates the halfedges in
/// `nonmanifold_edges` after flips. Returns 1 for each face of a one-sided component; DefectPolicy::error and ::repair
/// refuse such components with Error{precondition}. Cost: O(n).
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log);

/// Under DefectPolicy::largest, drops all components except the component with the largest area. `one_sided` is the
/// result of `orient_faces`. Throws Error{precondition} if the largest component is one-sided. Cost: O(n).
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);

/// Drops components in which no face has an area, which hold no other part of the surface together. If no component has
/// an area, all are kept. Call it after the cuts, which may leave such components behind. Cost: O(n).
void drop_zero_area_components(WorkFaces& work, DefectLog& log);

}  // namespace gvd
