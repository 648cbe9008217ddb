#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Puts generators that would collide back to where they come from: `to[i]` becomes `from[i]` where another point of
/// `to` is closer to it than `gap` in space and one of the two has moved. The points of `from` must not coincide.
/// Returns how many were put back. Cost: O(m log m) for m points that are not crowded along x, for each of a few
/// rounds.
std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to);

}  // namespace gvd
