#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Faces with a Q below kSliverQ, ascending. Cost: O(n).
std::vector<FaceId> find_slivers(const Mesh& remesh);

/// Adds at most `max_count` generators beside slivers if that leaves fewer slivers.
///
/// `remesh`: that of `diagram`, without defects. `accept(generators)`: whether their remesh is right and has fewer
/// slivers; if so, it has made `diagram` and `remesh` theirs. Deterministic. Cost: six remeshes at most.
void repair_slivers(const Mesh& mesh, const Diagram& diagram, const Mesh& remesh, std::size_t max_count,
                    const std::function<bool(const std::vector<SurfacePoint>&)>& accept);

}  // namespace gvd
