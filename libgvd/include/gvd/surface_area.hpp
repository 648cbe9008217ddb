#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

/// The area of all faces, summed in the order of their ids; square mesh units. Cost: O(n).
double compute_area(const Mesh& mesh);

}  // namespace gvd
