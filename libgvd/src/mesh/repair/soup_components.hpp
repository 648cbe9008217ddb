#pragma once

#include <vector>

#include "gvd/vec.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// A triangle counts as one without area if its height is at most this fraction of its longest side. Dimensionless. Ten
/// times the rounding error of a position on the side.
inline constexpr double kHeightWithoutArea = 1e-15;

/// Flips faces so that each component follows the majority of its faces. The halfedges in `nonmanifold_edges` follow
/// the flips. Returns per face 1 where its component has one side only; DefectPolicy::error and ::repair refuse that
/// with Error{precondition}. Cost: O(n).
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log);

/// Under DefectPolicy::largest: drops the faces of all components but the one with the largest area. `one_sided` is the
/// result of `orient_faces`. Throws Error{precondition} where the largest one has one side only. Cost: O(n).
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);

/// Drops the components of which no face has area: nothing else hangs on them. Where no component has
/// an area, all are kept. Comes after the cuts, which may leave such components behind. Cost: O(n).
void drop_zero_area_components(WorkFaces& work, DefectLog& log);

}  // namespace gvd
