#pragma once

#include <cstddef>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

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
