// gvd-bench: the cost of a diagram and of its steps, in multiples of a plain Dijkstra on the same mesh in the same run.
//
// Each row is one mesh, one number of generators m (random vertices, seeded) and one method, on one thread. Times are
// medians of processor time. The Dijkstra runs on a graph that is built beforehand; the diagram starts from the mesh.
// Memory is the peak of what the diagram holds, without the input mesh, counted in a run of its own.
// --threads T adds the wall-clock times of one thread and of T threads, in alternating runs, and their ratio.
// --peers adds a table with the cost of CGAL's geodesic distances.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "baseline.hpp"
#include "clocks.hpp"
#include "command_line.hpp"
#include "gvd/diagram.hpp"
#include "gvd/diagram_steps.hpp"
#include "heap_meter.hpp"
#ifdef GVD_HAS_PEERS
#include "peers.hpp"
#endif

namespace gvd::bench {
namespace {

/// The columns. Exact diagrams have no growth; that column shows their step "faces", the corresponding one.
constexpr std::array<std::string_view, 4> kColumns{steps::kDistances, steps::kBisectors, steps::kGrowth, steps::kCells};

struct Settings {
  std::vector<std::string> meshes;
  std::vector<int> generator_counts{5, 30, 100};
  int runs = 5;
  int refinements = 0;
  std::uint64_t seed = 0;
  std::vector<std::string> methods{"exact", "gbgvd"};
  Front front = Front::circle;
  double chord_tolerance = DiagramOptions{}.chord_tolerance;
  int threads = 1;
  bool peers = false;
};

struct Row {
  std::string mesh;
  int faces = 0;
  int generators = 0;
  std::string method;
  double dijkstra = 0;  ///< milliseconds
  double diagram = 0;   ///< milliseconds
  StepTimes steps;
  double bytes_a_face = 0;
  double wall_one = 0;   ///< milliseconds of wall-clock time, one thread
  double wall_many = 0;  ///< and as many as are asked for
};

double milliseconds(const std::function<void()>& work) {
  const double start = cpu_milliseconds();
  work();
  return cpu_milliseconds() - start;
}

double wall_milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The median of every step over the runs, in the order of the first run.
StepTimes median_steps(const std::vector<StepTimes>& runs) {
  StepTimes medians;
  for (std::size_t step = 0; step < runs.front().size(); ++step) {
    std::vector<double> values;
    for (const StepTimes& run : runs) values.push_back(run[step].second);
    medians.emplace_back(runs.front()[step].first, median(values));
  }
  return medians;
}

double peak_bytes_a_face(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  const HeapMeter meter;
  const Diagram diagram = compute_diagram(mesh, generators, options);
  return double(meter.peak()) / mesh.face_count();
}

void measure_threads(const Mesh& mesh, const std::vector<SurfacePoint>& generators, DiagramOptions options,
                     const Settings& settings, Row& row) {
  if (settings.threads == 1) return;
  std::vector<double> one, many;
  for (int run = 0; run < settings.runs; ++run) {
    options.threads = 1;
    one.push_back(wall_milliseconds([&] { compute_diagram(mesh, generators, options); }));
    options.threads = settings.threads;
    many.push_back(wall_milliseconds([&] { compute_diagram(mesh, generators, options); }));
  }
  row.wall_one = median(one);
  row.wall_many = median(many);
}

Row measure(const std::string& name, const Mesh& mesh, int count, const std::string& method, const Settings& settings) {
  const std::vector<VertexId> vertices = draw_vertices(mesh, count, settings.seed);
  std::vector<SurfacePoint> generators;
  for (const VertexId v : vertices) generators.push_back(vertex_point(mesh, v));
  DiagramOptions options;
  options.method = method == "exact" ? Method::exact : method == "paper" ? Method::paper : Method::gbgvd;
  options.front = method == "paper" ? Front::planar : settings.front;
  options.chord_tolerance = settings.chord_tolerance;
  options.threads = 1;

  Row row{name, mesh.face_count(), static_cast<int>(vertices.size()), method, 0, 0, {}, 0, 0, 0};
  row.bytes_a_face = peak_bytes_a_face(mesh, generators, options);  // also warms up the caches
  const EdgeGraph graph = build_edge_graph(mesh);
  std::vector<double> dijkstra, diagram;
  std::vector<StepTimes> steps;
  // Alternating, so that a slow phase of the machine affects both.
  for (int run = 0; run < settings.runs; ++run) {
    dijkstra.push_back(milliseconds([&] { compute_edge_distances(graph, vertices); }));
    StepClock clock;
    options.progress = clock.progress();
    diagram.push_back(milliseconds([&] { compute_diagram(mesh, generators, options); }));
    steps.push_back(clock.finish());
  }
  row.dijkstra = median(dijkstra);
  row.diagram = median(diagram);
  row.steps = median_steps(steps);
  options.progress = {};
  measure_threads(mesh, generators, options, settings, row);
  return row;
}

void print_header(const Settings& settings) {
  std::cout << fmt::format("{:<22} {:>8} {:>5} {:<6} {:>12} {:>9} |", "mesh", "faces", "m", "method", "Dijkstra ms",
                           "diagram x");
  for (const std::string_view step : kColumns) std::cout << fmt::format(" {:>12}", fmt::format("{} x", step));
  std::cout << fmt::format(" | {:>12}", "bytes/face");
  if (settings.threads > 1) {
    std::cout << fmt::format(" | {:>12} {:>12} {:>8}", "1 thread ms", fmt::format("{} threads", settings.threads),
                             "speed-up");
  }
  std::cout << "\n";
}

double time_of(const StepTimes& steps, std::string_view name) {
  for (const auto& [step, time] : steps) {
    if (step == name || (step == steps::kFaces && name == steps::kGrowth)) return time;
  }
  return 0;
}

void print_row(const Row& row) {
  std::cout << fmt::format("{:<22} {:>8} {:>5} {:<6} {:>12.3f} {:>9.2f} |", row.mesh, row.faces, row.generators,
                           row.method, row.dijkstra, row.diagram / row.dijkstra);
  for (const std::string_view step : kColumns) {
    std::cout << fmt::format(" {:>12.2f}", time_of(row.steps, step) / row.dijkstra);
  }
  std::cout << fmt::format(" | {:>12.0f}", row.bytes_a_face);
  if (row.wall_many > 0) {
    std::cout << fmt::format(" | {:>12.1f} {:>12.1f} {:>8.2f}", row.wall_one, row.wall_many,
                             row.wall_one / row.wall_many);
  }
  std::cout << std::endl;
}

/// Calls `visit` with the name and the mesh of every file, at every level of refinement.
void for_each_mesh(const Settings& settings, const std::function<void(const std::string&, const Mesh&)>& visit) {
  for (const std::string& path : settings.meshes) {
    auto [stem, mesh] = read_named_mesh(path);
    for (int level = 0; level <= settings.refinements; ++level) {
      if (level > 0) mesh = refine_flat(mesh);
      const std::string name = level == 0 ? stem : fmt::format("{} /{}", stem, 1 << 2 * level);
      visit(name, mesh);
    }
  }
}

#ifdef GVD_HAS_PEERS
void measure_peers(const std::string& name, const Mesh& mesh, int count, const Settings& settings) {
  const std::vector<VertexId> vertices = draw_vertices(mesh, count, settings.seed);
  const EdgeGraph graph = build_edge_graph(mesh);
  std::vector<double> dijkstra, paths, heat, heat_again;
  for (int run = 0; run < settings.runs; ++run) {
    dijkstra.push_back(milliseconds([&] { compute_edge_distances(graph, vertices); }));
    const PeerTimes times = time_peers(mesh, vertices);
    paths.push_back(times.shortest_paths);
    heat.push_back(times.heat);
    heat_again.push_back(times.heat_again);
  }
  const double unit = median(dijkstra);
  std::cout << fmt::format("{:<22} {:>8} {:>5} {:>12.3f} | {:>16.1f} {:>8.1f} {:>14.1f}\n", name, mesh.face_count(),
                           vertices.size(), unit, median(paths) / unit, median(heat) / unit, median(heat_again) / unit)
            << std::flush;
}
#endif

void run_peers([[maybe_unused]] const Settings& settings) {
#ifdef GVD_HAS_PEERS
  std::cout << fmt::format("\n{:<22} {:>8} {:>5} {:>12} | {:>16} {:>8} {:>14}\n", "CGAL's distances", "faces", "m",
                           "Dijkstra ms", "shortest paths x", "heat x", "heat again x");
  for_each_mesh(settings, [&](const std::string& name, const Mesh& mesh) {
    for (const int count : settings.generator_counts) measure_peers(name, mesh, count, settings);
  });
#endif
}

void run_all(const Settings& settings) {
  print_header(settings);
  for_each_mesh(settings, [&](const std::string& name, const Mesh& mesh) {
    for (const int count : settings.generator_counts) {
      for (const std::string& method : settings.methods) print_row(measure(name, mesh, count, method, settings));
    }
  });
  if (settings.peers) run_peers(settings);
  std::cout << fmt::format("peak resident memory of the whole run: {:.1f} MB\n", double(peak_resident_bytes()) / 1e6);
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Times the steps of a geodesic Voronoi diagram against a plain Dijkstra on the mesh's edges");
  add_mesh_arguments(app, settings.meshes);
  app.add_option("-m,--generators", settings.generator_counts, "numbers of generators")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  app.add_option("--runs", settings.runs, "runs; each time is their median")->check(CLI::PositiveNumber);
  app.add_option("--refine", settings.refinements,
                 "also measure the mesh with every face cut in four, up to this many times")
      ->check(CLI::Range(0, 6));
  app.add_option("--seed", settings.seed, "seed for drawing the generators");
  app.add_option("--method", settings.methods, "exact, gbgvd, paper, or several (default: exact and gbgvd)")
      ->delimiter(',')
      ->check(CLI::IsMember({"exact", "gbgvd", "paper"}));
  app.add_option("--chord-tolerance", settings.chord_tolerance,
                 "chord tolerance of exact diagrams, in mean edge lengths")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads, "also compare the wall-clock times of one thread and of this many")
      ->check(CLI::PositiveNumber);
#ifdef GVD_HAS_PEERS
  app.add_flag("--peers", settings.peers, "also time CGAL's exact shortest paths and its heat method");
#endif
  app.add_option("--front", settings.front, "front of gbgvd: planar or circle")
      ->transform(CLI::CheckedTransformer(
          std::vector<std::pair<std::string, Front>>{{"planar", Front::planar}, {"circle", Front::circle}}));
  CLI11_PARSE(app, argc, argv);
  run_all(settings);
  return 0;
}

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-bench", gvd::bench::run, argc, argv); }
