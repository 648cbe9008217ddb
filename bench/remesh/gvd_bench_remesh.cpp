// gvd-bench-remesh: topology, distances, triangles and costs of gvd-remesh, beside the figures of other programs.
//
// Times are processor times of one thread. The plain Dijkstra of the same meshes and numbers of generators is the
// yardstick for other machines.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "baseline.hpp"
#include "clocks.hpp"
#include "command_line.hpp"
#include "remesh_run.hpp"

namespace gvd::bench {
namespace {

struct Settings {
  std::vector<std::string> meshes;
  std::vector<int> vertex_counts{100, 500, 2000};
  std::vector<std::string> crease_models{"fandisk"};
  double features = 40;
};

/// What the results of one number of vertices add up to.
struct Totals {
  int models = 0, right = 0, made = 0;  ///< meshes, remeshes with their topology, and remeshes that did not fail
  double worst_inflation = 0;           ///< largest number of vertices / n
  RemeshFigures sum;
  std::vector<double> kept;  ///< of the runs with --features
  double dijkstra = 0;       ///< seconds
};

double dijkstra_seconds(const Mesh& mesh, int count) {
  const EdgeGraph graph = build_edge_graph(mesh);
  const std::vector<VertexId> vertices = draw_vertices(mesh, std::min(count, mesh.vertex_count()), 0);
  const double start = cpu_milliseconds();
  compute_edge_distances(graph, vertices);
  return (cpu_milliseconds() - start) / 1e3;
}

void print_head() {
  std::cout << fmt::format("  {:22} {:>5} {:>6} {:>6} {:>6} {:>5} {:>5} {:>6} {:>6} {:>6} {:>6} {:>8}\n", "model",
                           "topol", "vert/n", "Hausd", "RMS", "Q", "angle", "rounds", "CPU", "made", "diagr%",
                           "Dijkstra");
}

void print_figures(const std::string& name, const RemeshFigures& f, double dijkstra) {
  std::cout << fmt::format(
                   "  {:22} {:>5} {:6.3f} {:6.3f} {:6.4f} {:5.3f} {:5.1f} {:6.1f} {:6.2f} {:6.2f} {:6.1f} {:8.4f}\n",
                   name, f.right_topology ? "right" : "wrong", f.inflation, f.hausdorff, f.rms, f.q, f.angle, f.rounds,
                   f.seconds, f.made_seconds, f.diagrams, dijkstra)
            << std::flush;
}

void add(const RemeshFigures& f, Totals& totals) {
  ++totals.made;
  totals.right += f.right_topology;
  totals.worst_inflation = std::max(totals.worst_inflation, f.inflation);
  RemeshFigures& sum = totals.sum;
  sum.inflation += f.inflation;
  sum.hausdorff += f.hausdorff;
  sum.rms += f.rms;
  sum.q += f.q;
  sum.angle += f.angle;
  sum.rounds += f.rounds;
  sum.seconds += f.seconds;
  sum.made_seconds += f.made_seconds;
}

void measure_creases(const NamedMesh& input, RemeshRequest request, double angle, Totals& totals) {
  request.features = angle;
  const auto figures = run_remesh(input.mesh, request);
  if (!figures) {
    std::cout << fmt::format("  {} with --features {}: failed\n", input.name, angle);
    return;
  }
  print_figures(fmt::format("{} --features", input.name), *figures, dijkstra_seconds(input.mesh, request.vertices));
  std::cout << fmt::format("  {:22} {:.1f} % of the creases kept\n", "", figures->kept);
  totals.kept.push_back(figures->kept);
}

void measure_model(const std::string& path, int count, const Settings& settings, Totals& totals) {
  const NamedMesh input = read_named_mesh(path);
  const double dijkstra = dijkstra_seconds(input.mesh, count);
  ++totals.models;
  totals.dijkstra += dijkstra;
  const RemeshRequest request{path, count, std::nullopt};
  if (const auto figures = run_remesh(input.mesh, request)) {
    print_figures(input.name, *figures, dijkstra);
    add(*figures, totals);
  } else {
    std::cout << fmt::format("  {}: failed\n", input.name) << std::flush;
  }
  const auto& models = settings.crease_models;
  if (std::find(models.begin(), models.end(), input.name) != models.end()) {
    measure_creases(input, request, settings.features, totals);
  }
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / double(values.size());
}

/// In the order of peer_figures.
std::vector<double> compared_figures(const Totals& totals) {
  const double made = std::max(1, totals.made);
  return {double(totals.right),  totals.worst_inflation, totals.sum.hausdorff / made,
          totals.sum.rms / made, totals.sum.q / made,    totals.sum.seconds,
          mean(totals.kept)};
}

void print_means(const Totals& totals) {
  const double made = std::max(1, totals.made);
  std::cout << fmt::format(
      "  means of {} of {} models: topology right {}; vertices / n {:.3f}, at worst {:.3f}; Hausdorff {:.3f} %, RMS "
      "{:.4f} %; Q {:.3f}; median angle {:.1f}; rounds {:.1f}\n  sums: CPU {:.2f} s, of which relaxation, diagrams, "
      "duals and "
      "placement {:.2f} s ({:.0f} Dijkstras); a plain Dijkstra {:.4f} s\n",
      totals.made, totals.models, totals.right, totals.sum.inflation / made, totals.worst_inflation,
      totals.sum.hausdorff / made, totals.sum.rms / made, totals.sum.q / made, totals.sum.angle / made,
      totals.sum.rounds / made, totals.sum.seconds, totals.sum.made_seconds, totals.sum.made_seconds / totals.dijkstra,
      totals.dijkstra);
}

/// The peers' figures are of nine models: beside any other number of them they mean nothing.
void print_peers(int count, const Totals& totals) {
  const std::vector<PeerRow> peers = peer_figures(count);
  if (totals.models != 9 || peers.empty()) return;
  const std::vector<double> ours = compared_figures(totals);
  std::cout << fmt::format("  {:22} {:>8} {:>8} {:>8} {:>8}\n", "", "ours", kPeers[0], kPeers[1], kPeers[2]);
  for (std::size_t i = 0; i < peers.size(); ++i) {
    if (peers[i].figure == std::string("creases kept, %") && totals.kept.empty()) continue;
    std::cout << fmt::format("  {:22} {:8.3f}", peers[i].figure, ours[i]);
    for (const auto& value : peers[i].values) {
      std::cout << (value ? fmt::format(" {:8.3f}", *value) : fmt::format(" {:>8}", "-"));
    }
    std::cout << fmt::format("   {}\n", compare_with_best(ours[i], peers[i]));
  }
}

void add_options(CLI::App& app, Settings& settings) {
  add_mesh_arguments(app, settings.meshes);
  app.add_option("-n,--vertices", settings.vertex_counts, "numbers of vertices")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  app.add_option("--crease-models", settings.crease_models,
                 "names of the meshes that are remeshed with --features, too (default: fandisk)")
      ->delimiter(',');
  app.add_option("--features", settings.features, "angle for these, degrees (default: 40)")->check(CLI::PositiveNumber);
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Measures remeshes of gvd-remesh, beside the figures of other programs");
  add_options(app, settings);
  CLI11_PARSE(app, argc, argv);
  for (const int count : settings.vertex_counts) {
    std::cout << fmt::format("n = {}\n", count);
    print_head();
    Totals totals;
    for (const std::string& path : settings.meshes) measure_model(path, count, settings, totals);
    print_means(totals);
    print_peers(count, totals);
  }
  return 0;
}

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-bench-remesh", gvd::bench::run, argc, argv); }
