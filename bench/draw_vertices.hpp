#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd::bench {

/// `count` different vertices, or all of them where there are fewer: those of `--sampling vertices` with this seed.
std::vector<VertexId> draw_vertices(const Mesh& mesh, int count, std::uint64_t seed);

}  // namespace gvd::bench
