#pragma once

#include <vector>

#include "gvd/lloyd.hpp"

namespace gvd {

/// The iterations of relax_generators on the mesh itself, which neither use a copy nor keep extremities. The options
/// have been checked, and there are generators. With `ends_on_copy` the mesh is the copy, and the result has no
/// diagram.
/// Throws Error{interrupted} and Error{precondition} as relax_generators does.
LloydResult relax_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options);

}  // namespace gvd
