// The common ground of all measurements: random generators, finer meshes, and a plain Dijkstra as the unit of time.
//
// Times of different machines compare in multiples of the Dijkstra's, measured in the same run on the same mesh. It
// visits each vertex once and reads each edge twice, so that it measures what any propagation has to pay: the queue and
// the memory. Its graph is built beforehand and its distances overestimate the geodesic ones, which does not matter.
// The generators are those of `--sampling vertices` with the same seed, so that a command can repeat a row.
// A refined mesh has the same geodesic distances as its input, which separates the cost of faces from that of shape.
#include "baseline.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "clocks.hpp"
#include "geodesic/sampling/samplers.hpp"

namespace gvd::bench {

EdgeGraph build_edge_graph(const Mesh& mesh) {
  IdVector<VertexId, std::vector<std::pair<VertexId, double>>> rows(mesh.vertex_count());
  for (const EdgeId e : mesh.edges()) {
    const VertexId from = mesh.from(mesh.halfedge(e)), to = mesh.to(mesh.halfedge(e));
    rows[from].emplace_back(to, mesh.length(e));
    rows[to].emplace_back(from, mesh.length(e));
  }
  EdgeGraph graph{{0}, {}, {}};
  for (const auto& row : rows) {
    for (const auto& [neighbour, length] : row) {
      graph.neighbour.push_back(neighbour.value());
      graph.length.push_back(length);
    }
    graph.first.push_back(static_cast<std::int32_t>(graph.neighbour.size()));
  }
  return graph;
}

std::vector<double> compute_edge_distances(const EdgeGraph& graph, const std::vector<VertexId>& generators) {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> distance(graph.first.size() - 1, kInfinity);
  for (const VertexId v : generators) {
    distance[v.index()] = 0;
    queue.emplace(0.0, v.value());
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[std::size_t(v)]) continue;
    for (std::int32_t i = graph.first[v]; i < graph.first[v + 1]; ++i) {
      const double through = d + graph.length[i];
      double& known = distance[graph.neighbour[i]];
      if (through >= known) continue;
      known = through;
      queue.emplace(through, graph.neighbour[i]);
    }
  }
  return distance;
}

double dijkstra_seconds(const Mesh& mesh, int count, int runs) {
  const EdgeGraph graph = build_edge_graph(mesh);
  const std::vector<VertexId> generators = draw_vertices(mesh, count, 0);
  const auto run = [&] { return cpu_milliseconds([&] { compute_edge_distances(graph, generators); }) / 1e3; };
  return measure_medians(runs, run)[0];
}

std::vector<VertexId> draw_vertices(const Mesh& mesh, int count, std::uint64_t seed) {
  return gvd::draw_vertices(mesh, std::min(count, mesh.vertex_count()), seed);
}

std::vector<SurfacePoint> draw_vertex_points(const Mesh& mesh, int count, std::uint64_t seed) {
  std::vector<SurfacePoint> points;
  for (const VertexId v : draw_vertices(mesh, count, seed)) points.push_back(vertex_point(mesh, v));
  return points;
}

Mesh refine_flat(const Mesh& mesh) {
  std::vector<Vec3> positions = mesh.positions();
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    positions.push_back((mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))) / 2);
  }
  std::vector<std::array<VertexId, 3>> faces;
  faces.reserve(4 * mesh.face_count());
  const auto middle = [&](HalfedgeId h) { return VertexId(std::int64_t{mesh.vertex_count()} + mesh.edge(h).value()); };
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    const auto& [h, i, j] = Mesh::halfedges(f);
    const VertexId ab = middle(h), bc = middle(i), ca = middle(j);
    faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace gvd::bench
