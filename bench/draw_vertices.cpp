#include "draw_vertices.hpp"

#include <algorithm>

#include "geodesic/sampling/samplers.hpp"

namespace gvd::bench {

std::vector<VertexId> draw_vertices(const Mesh& mesh, int count, std::uint64_t seed) {
  return gvd::draw_vertices(mesh, std::min(count, mesh.vertex_count()), seed);
}

}  // namespace gvd::bench
