#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Estimates where a remesh has to add generators on creases: along curves that are closer to each other than their
/// generators. Returns a place for each expected generator. `corner_distance`: as in `trace_creases`.
///
/// The relaxation moves generators of one curve opposite the gaps of the other, and each then needs another generator
/// opposite. A few more are added at bends and beside free generators.
/// Cost: O(k log k) for k samples of the curves, as long as each has few samples nearby.
std::vector<Vec3> expect_opposite_generators(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                             double corner_distance);

}  // namespace gvd
