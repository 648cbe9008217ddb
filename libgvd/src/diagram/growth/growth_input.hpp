#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/generator_table.hpp"
#include "gvd/front.hpp"
#include "gvd/vec.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The input of all steps of growth: overlapping distances, and the labels chosen from them.
struct GrowthInput {
  const WorkingMesh& working;
  const GeneratorTable& table;  ///< tables of fast marching (section 4.1), or of windows
  const NearestLabels& labels;
  Front front;

  const Mesh& mesh() const { return working.mesh(); }
};

/// The number of generators that may be the nearest in a part of f, which are the generators in its table that are not
/// dominated.
inline int count_competing(const GeneratorTable& table, FaceId f) {
  int competing = 0;
  table.for_each(f, [&](const TableEntry& entry) { competing += entry.dominated ? 0 : 1; });
  return competing;
}

/// Distances of generator g at the corners of f, mesh units. If the tables have none for a corner, it is the distance
/// along an edge from another corner of f; infinity if no corner has a distance.
inline std::array<double, 3> corner_distances(const GrowthInput& input, FaceId f, GeneratorId g) {
  const Mesh& mesh = input.mesh();
  std::array<double, 3> d{kInfinity, kInfinity, kInfinity};
  const auto& corners = mesh.vertices(f);
  for (int i = 0; i < 3; ++i) {
    const std::int32_t entry = input.table.find(corners[i], g);
    if (entry >= 0) d[i] = input.table.distance(entry).distance;
    if (input.labels.label[corners[i]] == g) d[i] = std::min(d[i], input.labels.distance[corners[i]]);
  }
  const std::array<double, 3> known = d;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, previous = (i + 2) % 3;
    const double from_next = known[next] + mesh.length(Mesh::halfedge(f, i));
    const double from_previous = known[previous] + mesh.length(Mesh::halfedge(f, previous));
    if (d[i] == kInfinity) d[i] = std::min(from_next, from_previous);
  }
  return d;
}

/// The distances of generator g at the corners of f if the tables have all three; otherwise nothing.
inline std::optional<std::array<double, 3>> table_distances(const GrowthInput& input, FaceId f, GeneratorId g) {
  std::array<double, 3> d{};
  for (int i = 0; i < 3; ++i) {
    const std::int32_t entry = input.table.find(input.mesh().vertices(f)[i], g);
    if (entry < 0) return std::nullopt;
    d[i] = input.table.distance(entry).distance;
  }
  return d;
}

}  // namespace gvd
