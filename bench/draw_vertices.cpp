#include "draw_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>

namespace gvd::bench {

std::vector<VertexId> draw_vertices(const Mesh& mesh, int count, std::uint64_t seed) {
  std::vector<int> order(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::mt19937_64 random(seed);
  std::vector<VertexId> drawn;
  for (std::size_t i = 0; i < std::min(order.size(), static_cast<std::size_t>(count)); ++i) {
    std::swap(order[i], order[i + random() % (order.size() - i)]);
    drawn.emplace_back(order[i]);
  }
  return drawn;
}

}  // namespace gvd::bench
