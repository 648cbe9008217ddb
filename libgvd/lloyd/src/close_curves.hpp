#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Where a remesh has to add generators on creases: along curves that are closer to each other than their generators, a
/// place for each that is expected. `corner_distance`: as in trace_creases.
///
/// The relaxation moves generators of two such curves to gaps of each other, and each then needs one more opposite.
/// Some more are added at bends and beside free generators.
/// Cost: O(k log k) for k samples of the curves, as long as few are in each other's reach.
std::vector<Vec3> expect_opposite_generators(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                             double corner_distance);

}  // namespace gvd
