// gvd-bench-remesh: topology, distances, triangles and costs of gvd-remesh, beside the figures of other programs.
//
// The command runs as a user runs it, on one thread with default options. A row is one mesh with n vertices asked for:
//   topol          right where Euler characteristic, components and boundary loops are the input's
//   vert/n         above 1 where the repair added generators for a valid mesh; other programs add vertices, too
//   Hausd, RMS     the larger of the distances from input to output and back, in % of the bounding box's diagonal
//   Q, angle       mean of 6 / sqrt(3) times inradius over longest edge; median of the triangles' smallest angles
//   least, <30     the smallest angle of all; percent of the triangles with an angle below 30 degrees
//   rounds         diagrams of the repair: each one costs as much as an iteration of the relaxation
//   CPU, made      processor seconds of the whole command, and of what makes the mesh: without reading and measuring
//   diagr%         the share of diagrams in `made`
//   Dijkstra       the plain Dijkstra of the same mesh with n generators: the yardstick for other machines
// A mesh whose run failed counts among the models, but not in the means. The figures of other programs (peers.tsv)
// stand beside: model by model, how far we are ahead of the best of them, or behind which one; and totals over all
// models.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "baseline.hpp"
#include "command_line.hpp"
#include "peer_figures.hpp"
#include "remesh_run.hpp"

namespace gvd::bench {
namespace {

struct Settings {
  std::vector<std::string> meshes;
  std::vector<int> vertex_counts{100, 500, 2000};
  std::vector<std::string> crease_models{"fandisk"};
  std::vector<PeerRun> peers = read_peer_runs(GVD_SOURCE_DIR "/bench/remesh/peers.tsv");
  double features = 40;
};

/// The results of one number of vertices.
struct Results {
  int models = 0;  ///< meshes, failed runs among them
  std::vector<RemeshFigures> made;
  std::vector<double> kept;        ///< creases, percent, of the runs with --features
  double dijkstra = 0;             ///< seconds
  std::vector<PeerRun> peers;      ///< on these meshes
  std::vector<std::string> lines;  ///< each model beside its peers
};

void print_head() {
  std::cout << fmt::format("  {:22} {:>5} {:>6} {:>6} {:>6} {:>5} {:>5} {:>5} {:>5} {:>6} {:>6} {:>6} {:>6} {:>8}\n",
                           "model", "topol", "vert/n", "Hausd", "RMS", "Q", "angle", "least", "<30", "rounds", "CPU",
                           "made", "diagr%", "Dijkstra");
}

void print_figures(const std::string& name, const RemeshFigures& f, double dijkstra) {
  std::cout << fmt::format(
                   "  {:22} {:>5} {:6.3f} {:6.3f} {:6.4f} {:5.3f} {:5.1f} {:5.1f} {:5.2f} {:6.1f} {:6.2f} {:6.2f} "
                   "{:6.1f} {:8.4f}\n",
                   name, f.right_topology ? "right" : "wrong", f.inflation, f.hausdorff, f.rms, f.q, f.angle,
                   f.least_angle, f.below_30, f.rounds, f.seconds, f.made_seconds, f.diagrams, dijkstra)
            << std::flush;
}

/// The programs of these runs, each one once, in the order of their names.
std::vector<std::string> programs_of(const std::vector<PeerRun>& runs) {
  std::set<std::string> programs;
  for (const PeerRun& run : runs) programs.insert(run.program);
  return {programs.begin(), programs.end()};
}

/// The lead of a remesh in each figure: how far it is before the best of its peers, or behind which one.
std::string beside_peers(const std::string& name, const RemeshQuality& ours, const std::vector<PeerRun>& runs) {
  std::vector<PeerValues> peers;
  for (const PeerRun& run : runs) peers.push_back({run.program, values_of(run.quality)});
  const FigureValues values = values_of(ours);
  std::string line = fmt::format("  {:22}", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    line += fmt::format(" | {}", compare_with_best(*values[i], peers, i, compared_figures()[i]));
  }
  return line;
}

/// The same mesh with its creases followed: how much of their length is kept. A line of its own, outside of the means.
void measure_creases(const NamedMesh& input, RemeshRequest request, double angle, Results& results) {
  request.features = angle;
  const auto figures = run_remesh(input.mesh, request);
  if (!figures) {
    std::cout << fmt::format("  {} with --features {}: failed\n", input.name, angle);
    return;
  }
  print_figures(fmt::format("{} --features", input.name), *figures, dijkstra_seconds(input.mesh, request.vertices, 1));
  std::cout << fmt::format("  {:22} {:.1f} % of the creases kept\n", "", *figures->creases_kept);
  results.kept.push_back(*figures->creases_kept);
}

void measure_model(const std::string& path, int count, const Settings& settings, Results& results) {
  const NamedMesh input = read_named_mesh(path);
  const double dijkstra = dijkstra_seconds(input.mesh, count, 1);
  ++results.models;
  results.dijkstra += dijkstra;
  const std::vector<PeerRun> peers = runs_on(settings.peers, input.name, count);
  results.peers.insert(results.peers.end(), peers.begin(), peers.end());
  const RemeshRequest request{path, count, std::nullopt};
  if (const auto figures = run_remesh(input.mesh, request)) {
    print_figures(input.name, *figures, dijkstra);
    results.made.push_back(*figures);
    if (!peers.empty()) results.lines.push_back(beside_peers(input.name, *figures, peers));
  } else {
    std::cout << fmt::format("  {}: failed\n", input.name) << std::flush;
  }
  if (contains(settings.crease_models, input.name)) measure_creases(input, request, settings.features, results);
}

/// Of the default runs; creases count where they were followed.
FigureValues our_totals(const Results& results) {
  std::vector<RemeshQuality> remeshes(results.made.begin(), results.made.end());
  for (RemeshQuality& quality : remeshes) quality.creases_kept.reset();
  FigureValues totals = totals_of(remeshes);
  if (!results.kept.empty()) {
    totals.back() = std::accumulate(results.kept.begin(), results.kept.end(), 0.0) / double(results.kept.size());
  }
  return totals;
}

void print_means(const Results& results) {
  const double made = double(std::max<std::size_t>(1, results.made.size()));
  const auto sum = [&](double RemeshFigures::*figure) {
    return std::accumulate(results.made.begin(), results.made.end(), 0.0,
                           [&](double all, const RemeshFigures& f) { return all + f.*figure; });
  };
  std::cout << fmt::format(
      "  {} of {} models: median angle {:.1f}, rounds {:.1f}, means; sums: CPU {:.2f} s, of which relaxation, "
      "diagrams, "
      "duals and placement {:.2f} s ({:.0f} Dijkstras); a plain Dijkstra {:.4f} s\n",
      results.made.size(), results.models, sum(&RemeshFigures::angle) / made, sum(&RemeshFigures::rounds) / made,
      sum(&RemeshFigures::seconds), sum(&RemeshFigures::made_seconds),
      sum(&RemeshFigures::made_seconds) / results.dijkstra, results.dijkstra);
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

/// Totals beside those of the programs that were measured on all these meshes, as the rows of a table.
void print_totals(const Results& results) {
  const std::vector<ComparedFigure>& figures = compared_totals();
  const FigureValues ours = our_totals(results);
  std::vector<PeerValues> peers;
  for (const std::string& program : programs_of(results.peers)) {
    std::vector<RemeshQuality> remeshes;
    for (const PeerRun& run : results.peers) {
      if (run.program == program) remeshes.push_back(run.quality);
    }
    if (std::cmp_equal(remeshes.size(), results.models)) peers.push_back({program, totals_of(remeshes)});
  }
  std::cout << fmt::format("  {:24} | {:>8}", "", "ours");
  for (const PeerValues& peer : peers) std::cout << fmt::format(" | {:>8}", peer.program);
  std::cout << " | against the best\n";
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::cout << fmt::format("  {:24} | {:>8}", figures[i].name, number(ours[i], figures[i].digits));
    for (const PeerValues& peer : peers)
      std::cout << fmt::format(" | {:>8}", number(peer.values[i], figures[i].digits));
    std::cout << fmt::format(" | {}\n", ours[i] ? compare_with_best(*ours[i], peers, i, figures[i]) : "");
  }
}

/// Each model's lead, figure by figure.
void print_models(const Results& results) {
  if (results.lines.empty()) return;
  std::cout << fmt::format("  {:22}", "beside the best");
  for (const ComparedFigure& figure : compared_figures()) std::cout << " | " << figure.name;
  std::cout << "\n";
  for (const std::string& line : results.lines) std::cout << line << "\n";
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
    Results results;
    for (const std::string& path : settings.meshes) measure_model(path, count, settings, results);
    print_means(results);
    print_totals(results);
    print_models(results);
  }
  return 0;
}

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-bench-remesh", gvd::bench::run, argc, argv); }
