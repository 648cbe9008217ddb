#pragma once

#include <vector>

#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"

namespace gvd {

/// The remesh with its vertices at their generators.
Mesh make_unplaced(const Mesh& input, const RemeshResult& result);

/// The pictures of a remesh for make_view_page. They are the remesh, the same before its vertices were placed
/// (`unplaced`) if any was, the input, and the diagram of all generators. The first two have the distances from the
/// input, the input those from the remesh, all with one scale. The added generators are marked. The scenes refer to the
/// meshes, which must outlive them. `threads` >= 1, or 0 for one a core. Cost: O(n log n).
std::vector<ViewScene> make_remesh_scenes(const Mesh& input, const RemeshResult& result, const Mesh& unplaced,
                                          int threads);

}  // namespace gvd
