#pragma once

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// The unit sphere, as an icosahedron with every face cut in four `subdivisions` times: 20 * 4^subdivisions faces.
Mesh make_icosphere(int subdivisions);

}  // namespace gvd::paper
