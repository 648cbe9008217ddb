#include "diagram/growth/growth_input.hpp"

#include <algorithm>
#include <cstdint>

#include "gvd/vec.hpp"

namespace gvd {
namespace {}  // namespace

std::array<double, 3> corner_distances(const GrowthInput& input, FaceId f, GeneratorId g) {
  const Mesh& mesh = input.mesh();
  std::array<double, 3> d{kInfinity, kInfinity, kInfinity};
  const auto& corners = mesh.vertices(f);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t entry = input.table.find(corners[i], g);
    if (entry >= 0) d[i] = input.table.distance(entry).distance;
    if (input.labels.label[corners[i]] == g) d[i] = std::min(d[i], input.labels.distance[corners[i]]);
  }
  const std::array<double, 3> known = d;
  for (std::size_t i = 0; i < 3; ++i) {
    const double next = known[(i + 1) % 3] + mesh.length(Mesh::halfedge(f, static_cast<int>(i)));
    const double previous = known[(i + 2) % 3] + mesh.length(Mesh::halfedge(f, static_cast<int>((i + 2) % 3)));
    if (d[i] == kInfinity) d[i] = std::min(next, previous);
  }
  return d;
}

std::optional<std::array<double, 3>> table_distances(const GrowthInput& input, FaceId f, GeneratorId g) {
  std::array<double, 3> d{};
  const auto& corners = input.mesh().vertices(f);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t entry = input.table.find(corners[i], g);
    if (entry < 0) return std::nullopt;
    d[i] = input.table.distance(entry).distance;
  }
  return d;
}

}  // namespace gvd
