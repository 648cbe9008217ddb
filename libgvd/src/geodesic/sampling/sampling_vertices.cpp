#include "geodesic/sampling/sampling_vertices.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numeric>
#include <utility>

#include "geodesic/sampling/sampling_random.hpp"
#include "gvd/error.hpp"

namespace gvd {

std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(order.begin(), order.end(), 0);
  SeededRandom random(seed);
  std::vector<VertexId> drawn;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    std::swap(order[i], order[i + random.below(order.size() - i)]);
    drawn.emplace_back(order[i]);
  }
  return drawn;
}

std::vector<SurfacePoint> sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  if (count > mesh.vertex_count()) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("{} different vertices asked for, and the mesh has {}; ask for fewer, or take random points", count,
                    mesh.vertex_count()));
  }
  std::vector<SurfacePoint> points;
  for (const VertexId v : draw_vertices(mesh, count, seed)) points.push_back(vertex_point(mesh, v));
  return points;
}

}  // namespace gvd
