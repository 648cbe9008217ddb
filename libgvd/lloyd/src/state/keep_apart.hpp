#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Undoes moves that would let generators collide: `to[i]` becomes `from[i]` if another point of `to` is within `gap`
/// of it (Euclidean, mesh units) and point i has moved. The points of `from` must be farther apart than `gap`.
/// Returns the number of moves undone. Cost: O(m log m) in each of a few rounds, for m points that are not crowded
/// along x.
std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to);

}  // namespace gvd
