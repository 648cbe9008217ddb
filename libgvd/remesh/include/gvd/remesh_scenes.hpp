#pragma once

#include <vector>

#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/remesh.hpp"

namespace gvd {

/// The remesh with its vertices at their generators. `result` must be a remesh of `input`. Cost: O(n).
Mesh make_unplaced(const Mesh& input, const RemeshResult& result);

/// The pictures of a remesh for make_view_page: the remesh, the input, and the diagram of all generators. Where
/// vertices were placed away from their generators, the remesh before that (`unplaced`, of make_unplaced) is a further
/// one. Remeshes have their distances from the input, the input those from the remesh, all with one scale. Added
/// generators are marked. The scenes refer to the meshes, which must outlive them. `threads` >= 1, or 0 for one a core.
/// Throws Error{interrupted} if `progress` cancels. Cost: O(n log n).
std::vector<ViewScene> make_remesh_scenes(const Mesh& input, const RemeshResult& result, const Mesh& unplaced,
                                          int threads, const Progress& progress = {});

}  // namespace gvd
