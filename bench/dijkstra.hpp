#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::bench {

/// The mesh's edges as a graph: compressed rows of neighbours and edge lengths.
struct EdgeGraph {
  std::vector<std::int32_t> first;      ///< per vertex, and one more: where its row begins
  std::vector<std::int32_t> neighbour;  ///< vertices
  std::vector<double> length;           ///< mesh units
};

EdgeGraph build_edge_graph(const Mesh& mesh);

/// The yardstick: plain multi-source Dijkstra along edges, with a std::priority_queue, entries never decreased but left
/// behind. Returns distances in mesh units, infinity where nothing reaches.
std::vector<double> compute_edge_distances(const EdgeGraph& graph, const std::vector<VertexId>& generators);

}  // namespace gvd::bench
