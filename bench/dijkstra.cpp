#include "dijkstra.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace gvd::bench {

EdgeGraph build_edge_graph(const Mesh& mesh) {
  EdgeGraph graph;
  graph.first.assign(std::size_t(mesh.vertex_count()) + 1, 0);
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    ++graph.first[mesh.from(h).index() + 1];
    ++graph.first[mesh.to(h).index() + 1];
  }
  for (std::size_t v = 1; v < graph.first.size(); ++v) graph.first[v] += graph.first[v - 1];
  graph.neighbour.resize(2 * std::size_t(mesh.edge_count()));
  graph.length.resize(graph.neighbour.size());
  std::vector<std::int32_t> end(graph.first.begin(), graph.first.end() - 1);
  const auto append = [&](VertexId from, VertexId to, double length) {
    const auto slot = static_cast<std::size_t>(end[from.index()]++);
    graph.neighbour[slot] = to.value();
    graph.length[slot] = length;
  };
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    append(mesh.from(h), mesh.to(h), mesh.length(EdgeId(e)));
    append(mesh.to(h), mesh.from(h), mesh.length(EdgeId(e)));
  }
  return graph;
}

std::vector<double> compute_edge_distances(const EdgeGraph& graph, const std::vector<VertexId>& generators) {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> distance(graph.first.size() - 1, std::numeric_limits<double>::infinity());
  for (const VertexId v : generators) {
    distance[v.index()] = 0;
    queue.emplace(0.0, v.value());
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[std::size_t(v)]) continue;
    for (auto i = std::size_t(graph.first[std::size_t(v)]); i < std::size_t(graph.first[std::size_t(v) + 1]); ++i) {
      const double through = d + graph.length[i];
      double& known = distance[std::size_t(graph.neighbour[i])];
      if (through < known) {
        known = through;
        queue.emplace(through, graph.neighbour[i]);
      }
    }
  }
  return distance;
}

}  // namespace gvd::bench
