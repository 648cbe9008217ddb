#pragma once

#include "gvd/mesh.hpp"

namespace gvd::bench {

/// The same surface with every face cut in four at its edges' midpoints. Cost: O(n).
Mesh refine_flat(const Mesh& mesh);

}  // namespace gvd::bench
