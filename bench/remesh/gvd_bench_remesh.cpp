// gvd-bench-remesh: topology, distances, triangles and costs of gvd-remesh, beside the figures of other programs.
//
// The command runs as a user runs it, on one thread with default options. A row is one mesh with n vertices asked for:
//   topol          right where Euler characteristic, components and boundary loops are the input's
//   vert/n         above 1 where the repair added generators for a valid mesh; other programs add vertices, too
//   Hausd, RMS     the larger of the distances from input to output and back, in % of the bounding box's diagonal
//   Q, angle       mean of 6 / sqrt(3) times inradius over longest edge; median of the triangles' smallest angles
//   rounds         diagrams of the repair: each one costs as much as an iteration of the relaxation
//   CPU, made      processor seconds of the whole command, and of what makes the mesh: without reading and measuring
//   diagr%         the share of diagrams in `made`
//   Dijkstra       the plain Dijkstra of the same mesh with n generators: the yardstick for other machines
// A mesh whose run failed counts among the models, but not in the means.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "baseline.hpp"
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

/// The figures whose means and sums are printed.
constexpr double RemeshFigures::*kSummed[]{
    &RemeshFigures::inflation, &RemeshFigures::hausdorff, &RemeshFigures::rms,     &RemeshFigures::q,
    &RemeshFigures::angle,     &RemeshFigures::rounds,    &RemeshFigures::seconds, &RemeshFigures::made_seconds};

void add(const RemeshFigures& f, Totals& totals) {
  ++totals.made;
  totals.right += f.right_topology;
  totals.worst_inflation = std::max(totals.worst_inflation, f.inflation);
  for (const auto figure : kSummed) totals.sum.*figure += f.*figure;
}

/// The same mesh with its creases followed: how much of their length is kept. A line of its own, outside of the means.
void measure_creases(const NamedMesh& input, RemeshRequest request, double angle, Totals& totals) {
  request.features = angle;
  const auto figures = run_remesh(input.mesh, request);
  if (!figures) {
    std::cout << fmt::format("  {} with --features {}: failed\n", input.name, angle);
    return;
  }
  print_figures(fmt::format("{} --features", input.name), *figures, dijkstra_seconds(input.mesh, request.vertices, 1));
  std::cout << fmt::format("  {:22} {:.1f} % of the creases kept\n", "", figures->kept);
  totals.kept.push_back(figures->kept);
}

void measure_model(const std::string& path, int count, const Settings& settings, Totals& totals) {
  const NamedMesh input = read_named_mesh(path);
  const double dijkstra = dijkstra_seconds(input.mesh, count, 1);
  ++totals.models;
  totals.dijkstra += dijkstra;
  const RemeshRequest request{path, count, std::nullopt};
  if (const auto figures = run_remesh(input.mesh, request)) {
    print_figures(input.name, *figures, dijkstra);
    add(*figures, totals);
  } else {
    std::cout << fmt::format("  {}: failed\n", input.name) << std::flush;
  }
  if (contains(settings.crease_models, input.name)) measure_creases(input, request, settings.features, totals);
}

/// In the order of peer_figures.
std::vector<double> compared_figures(const Totals& totals) {
  const double made = std::max(1, totals.made);
  const double kept = std::accumulate(totals.kept.begin(), totals.kept.end(), 0.0);
  return {double(totals.right),
          totals.worst_inflation,
          totals.sum.hausdorff / made,
          totals.sum.rms / made,
          totals.sum.q / made,
          totals.sum.seconds,
          kept / std::max(1.0, double(totals.kept.size()))};
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
  add_positive(app, "-n,--vertices", settings.vertex_counts, "numbers of vertices");
  app.add_option("--crease-models", settings.crease_models,
                 "names of the meshes that are remeshed with --features, too (default: fandisk)")
      ->delimiter(',');
  add_positive(app, "--features", settings.features, "angle for these, degrees (default: 40)");
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
