#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// The faces of a mesh with other vertex positions. Throws Error{precondition} where an edge has no length.
Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions);

}  // namespace gvd
