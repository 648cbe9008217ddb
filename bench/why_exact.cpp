// gvd-why-exact: how far simpler distances are from the exact ones, and how many vertices they give to a wrong
// generator.
//
// Each row is one mesh and one kind of distance from m random vertices, seeded. Euclidean distances run straight
// through space, Dijkstra's along the mesh's edges. The others come from CGAL's heat method and this library's fast
// marching. The first ones are lower bounds, Dijkstra's upper ones; both errors stay under refinement, because neither
// converges to the geodesic distance. The figures are means over several draws of generators:
//   wrong label     share of the vertices whose nearest generator is another one than by exact distances
//   cut off         share of the vertices that edges between vertices of one label do not join to their generator
//   in pieces       share of the cells that have such vertices
//   error           mean relative error of the distance from the nearest generator
// The row "exact" checks the measurement itself: its first and last figures are 0. Exact cells can be cut off along
// edges, too, where they are thinner than the mesh.
//
//   gvd-why-exact [MESH...] [-m 30] [--draws 10] [--refine 0]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/union_find.hpp"
#include "baseline.hpp"
#include "command_line.hpp"
#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#ifdef GVD_HAS_PEERS
#include "peers.hpp"
#endif

namespace gvd::bench {
namespace {

/// Generators whose distances differ by less than this fraction of them are equally near.
constexpr double kEquallyNear = 1e-9;

/// The nearest generator of every vertex, by its index in the list, and its distance. -1 and infinity where none
/// reaches.
struct Labels {
  std::vector<int> label;
  std::vector<double> distance;
};

/// Wrong label, cut off, in pieces and error, as fractions.
using Figures = Eigen::Array4d;

/// Distances of all vertices from each generator: one list for each.
using DistanceTable = std::vector<std::vector<double>>;
using ComputeDistances = std::function<DistanceTable(const Mesh&, const std::vector<VertexId>&)>;

struct Approach {
  std::string_view name;
  ComputeDistances compute;
};

DistanceTable compute_euclidean(const Mesh& mesh, const std::vector<VertexId>& generators) {
  DistanceTable table;
  for (const VertexId generator : generators) {
    std::vector<double>& row = table.emplace_back();
    for (const Vec3& p : mesh.positions()) row.push_back((p - mesh.position(generator)).norm());
  }
  return table;
}

DistanceTable compute_dijkstra(const Mesh& mesh, const std::vector<VertexId>& generators) {
  const EdgeGraph graph = build_edge_graph(mesh);
  DistanceTable table;
  for (const VertexId generator : generators) table.push_back(compute_edge_distances(graph, {generator}));
  return table;
}

DistanceTable compute_exact(const Mesh& mesh, const std::vector<VertexId>& generators) {
  DistanceTable table;
  for (const VertexId generator : generators) {
    const ExactField field(mesh, {vertex_point(mesh, generator)});
    std::vector<double>& row = table.emplace_back();
    for (const VertexId v : mesh.vertices()) row.push_back(field.distance(v));
  }
  return table;
}

DistanceTable compute_fast_marching(const Mesh& mesh, const std::vector<VertexId>& generators) {
  DiagramOptions options;
  options.method = Method::gbgvd;
  DistanceTable table;
  for (const VertexId generator : generators) {
    const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, generator)}, options);
    std::vector<double>& row = table.emplace_back();
    for (const VertexId v : mesh.vertices()) row.push_back(diagram.vertex_distance[v]);
  }
  return table;
}

std::vector<Approach> list_approaches() {
  return {{"Euclidean", compute_euclidean},
          {"Dijkstra", compute_dijkstra},
#ifdef GVD_HAS_PEERS
          {"heat method", compute_heat_distances},
#endif
          {"fast marching", compute_fast_marching},
          {"exact", compute_exact}};
}

Labels find_nearest(const DistanceTable& table) {
  Labels nearest;
  nearest.label.assign(table.front().size(), -1);
  nearest.distance.assign(table.front().size(), kInfinity);
  for (std::size_t g = 0; g < table.size(); ++g) {
    for (std::size_t v = 0; v < table[g].size(); ++v) {
      if (table[g][v] >= nearest.distance[v]) continue;
      nearest.distance[v] = table[g][v];
      nearest.label[v] = static_cast<int>(g);
    }
  }
  return nearest;
}

/// Whether edges between vertices of one label join each vertex to its generator.
std::vector<bool> find_joined(const EdgeGraph& graph, const std::vector<int>& label,
                              const std::vector<VertexId>& generators) {
  UnionFind sets(label.size());
  std::vector<bool> joined(label.size(), false);
  for (int v = 0; v < std::ssize(label); ++v) {
    for (int i = graph.first[v]; i < graph.first[v + 1]; ++i) {
      if (label[graph.neighbour[i]] == label[v]) sets.unite(v, graph.neighbour[i]);
    }
  }
  for (int v = 0; v < std::ssize(label); ++v) {
    joined[v] = label[v] >= 0 && sets.find(v) == sets.find(generators[label[v]].value());
  }
  return joined;
}

/// What `found` makes of the vertices that have an exact distance above zero.
Figures compare(const EdgeGraph& graph, const std::vector<VertexId>& generators, const DistanceTable& exact,
                const Labels& truth, const Labels& found) {
  const std::vector<bool> joined = find_joined(graph, found.label, generators);
  std::vector<bool> in_pieces(generators.size(), false);
  Figures sum = Figures::Zero();  // over the vertices, but for the share of the cells
  double vertices = 0;
  for (std::size_t v = 0; v < found.label.size(); ++v) {
    if (truth.label[v] < 0 || found.label[v] < 0 || truth.distance[v] == 0) continue;
    ++vertices;
    const auto g = static_cast<std::size_t>(found.label[v]);
    const bool is_wrong = exact[g][v] > truth.distance[v] * (1 + kEquallyNear);
    sum += Figures(is_wrong, !joined[v], 0, std::abs(found.distance[v] / truth.distance[v] - 1));
    if (!joined[v]) in_pieces[g] = true;
  }
  const auto cells = double(std::count(in_pieces.begin(), in_pieces.end(), true));
  return sum / vertices + Figures(0, 0, cells / double(generators.size()), 0);
}

void print_rows(const std::string& name, const Mesh& mesh, int count, int draws) {
  const EdgeGraph graph = build_edge_graph(mesh);
  const std::vector<Approach> approaches = list_approaches();
  std::vector<Figures> sums(approaches.size(), Figures::Zero());
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<VertexId> generators = draw_vertices(mesh, count, static_cast<std::uint64_t>(draw));
    const DistanceTable exact = compute_exact(mesh, generators);
    const Labels truth = find_nearest(exact);
    for (std::size_t i = 0; i < approaches.size(); ++i) {
      sums[i] += compare(graph, generators, exact, truth, find_nearest(approaches[i].compute(mesh, generators)));
    }
  }
  for (std::size_t i = 0; i < approaches.size(); ++i) {
    const Figures percent = 100 * sums[i] / draws;
    std::cout << fmt::format("{:<22} {:>7} {:>5} {:<14} {:>11.2f} % {:>8.2f} % {:>9.1f} % {:>9.3f} %\n", name,
                             mesh.face_count(), count, approaches[i].name, percent[0], percent[1], percent[2],
                             percent[3]);
  }
  std::cout << std::flush;
}

int run(int argc, char** argv) {
  std::vector<std::string> meshes;
  int count = 30, draws = 10, refinements = 0;
  CLI::App app("Compares labels and distances of simpler methods with the exact ones, at the vertices");
  add_mesh_arguments(app, meshes);
  add_positive(app, "-m,--generators", count, "number of generators: random vertices");
  add_positive(app, "--draws", draws, "draws of generators of which the mean is taken");
  app.add_option("--refine", refinements, "cut every face in four, this many times over")->check(CLI::Range(0, 4));
  CLI11_PARSE(app, argc, argv);
  std::cout << fmt::format("{:<22} {:>7} {:>5} {:<14} {:>13} {:>10} {:>11} {:>11}\n", "mesh", "faces", "m", "distances",
                           "wrong label", "cut off", "in pieces", "error");
  for (const std::string& path : meshes) {
    auto [name, mesh] = read_named_mesh(path);
    for (int level = 0; level < refinements; ++level) mesh = refine_flat(mesh);
    print_rows(name, mesh, count, draws);
  }
  return 0;
}

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-why-exact", gvd::bench::run, argc, argv); }
