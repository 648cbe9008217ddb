#pragma once

#include <optional>
#include <vector>

#include "gvd/lloyd.hpp"

namespace gvd {

/// The relaxation on `options.copy` first, and then on the mesh. Nothing where the copy can't be used: it has more than
/// half of the faces, or generators that are apart on the mesh coincide on it.
std::optional<LloydResult> relax_from_copy(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                           const LloydOptions& options);

}  // namespace gvd
