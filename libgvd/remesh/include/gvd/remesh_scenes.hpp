#pragma once

#include <vector>

#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/remesh.hpp"

namespace gvd {

/// The remesh with its vertices at their generators. `result` must be a remesh of `input`. Cost: O(n).
Mesh make_unplaced(const Mesh& input, const RemeshResult& result);

/// The pictures of a remesh for make_view_page: the remesh, the input, and the diagram of all generators. If vertices
/// were placed away from their generators, there is also the remesh before that (`unplaced`, see make_unplaced).
/// Remeshes show their distances from the input, and the input shows its distances from the remesh, all on one scale.
/// Added generators are marked. The scenes refer to the meshes, which must outlive them. `threads` >= 1, or 0 for one
/// for each core. Throws Error{interrupted} if `progress` cancels. Cost: O(n log n).
std::vector<ViewScene> make_remesh_scenes(const Mesh& input, const RemeshResult& result, const Mesh& unplaced,
                                          int threads, const Progress& progress = {});

}  // namespace gvd
