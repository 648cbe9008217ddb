#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::bench {

/// The mesh's edges as a graph: compressed rows of neighbours and edge lengths.
struct EdgeGraph {
  std::vector<std::int32_t> first;      ///< per vertex, and one more: beginning of its row
  std::vector<std::int32_t> neighbour;  ///< vertices
  std::vector<double> length;           ///< mesh units
};

EdgeGraph build_edge_graph(const Mesh& mesh);

/// The unit of time: plain multi-source Dijkstra along edges, with a std::priority_queue in which outdated entries
/// stay.
/// Returns distances in mesh units, infinity for vertices that no generator reaches.
std::vector<double> compute_edge_distances(const EdgeGraph& graph, const std::vector<VertexId>& generators);

/// The unit in seconds of processor time, with `count` random generators (seed 0): the median of `runs` >= 1 runs.
double dijkstra_seconds(const Mesh& mesh, int count, int runs);

/// `count` different vertices, or all of them where there are fewer: those of `--sampling vertices` with this seed.
std::vector<VertexId> draw_vertices(const Mesh& mesh, int count, std::uint64_t seed);

/// The same vertices as points of the surface.
std::vector<SurfacePoint> draw_vertex_points(const Mesh& mesh, int count, std::uint64_t seed);

/// The same surface with every face cut in four at its edges' midpoints. Cost: O(n).
Mesh refine_flat(const Mesh& mesh);

}  // namespace gvd::bench
