// gvd-bench: the cost of a diagram and of its steps, in multiples of a plain Dijkstra on the same mesh in the same run.
//
// Each row is one mesh, one number of generators m (random vertices, seeded) and one method, on one thread. Times are
// medians of processor time. The Dijkstra runs on a graph that is built beforehand; the diagram starts from the mesh.
//   Dijkstra ms      the unit of the row, which tells the machine
//   diagram x        the whole diagram in these units; section 5.1 of the paper gives milliseconds of its machine
//   STEP x           its steps by name (gvd/diagram_steps.hpp). The working mesh and the tables have no column. So the
//                    steps add up to less than the diagram
//   bytes/face       the peak of what the diagram holds, without the input mesh, counted in a run of its own
//   1 thread ms ...  with --threads T, wall-clock times of one thread and of T, measured in turns, and their ratio
// --moves K adds a table with the median time of K moves of a generator (gvd/diagram_editor.hpp): by two faces, and to
// random faces. Each move takes turns with a new diagram of the same generators.
// --peers adds a table with the cost of CGAL's geodesic distances, which yield neither labels nor bisectors.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "baseline.hpp"
#include "clocks.hpp"
#include "command_line.hpp"
#include "gvd/diagram.hpp"
#include "gvd/diagram_editor.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "heap_meter.hpp"
#ifdef GVD_HAS_PEERS
#include "peers.hpp"
#endif

namespace gvd::bench {
namespace {

/// The columns. Exact diagrams have no growth; that column shows their step "faces", the corresponding one.
constexpr std::array<std::string_view, 4> kColumns{steps::kDistances, steps::kBisectors, steps::kGrowth, steps::kCells};

/// Faces that a near move crosses.
constexpr int kStepFaces = 2;

struct Settings {
  std::vector<std::string> meshes;  ///< paths
  std::vector<int> generator_counts{5, 30, 100};
  int runs = 5;         ///< each time is the median of as many
  int refinements = 0;  ///< levels above the input, each with four times the faces
  std::uint64_t seed = 0;
  std::vector<std::string> methods{"exact", "gbgvd"};
  Front front = Front::circle;                                ///< of gbgvd; the paper's steps have planar fronts
  double chord_tolerance = DiagramOptions{}.chord_tolerance;  ///< mean edge lengths
  int threads = 1;                                            ///< above 1: compared with one
  int moves = 0;  ///< of random generators, whose cost a table of its own compares with that of a new diagram
  bool peers = false;
  std::string save;  ///< file for the last refinement; empty: none
};

/// The largest heap of a run without clocks, less than what was there before it.
double peak_bytes_a_face(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  const HeapMeter meter;
  const Diagram diagram = compute_diagram(mesh, generators, options);
  return double(meter.peak()) / mesh.face_count();
}

/// One thread, whatever --threads says: steps are compared in processor time.
DiagramOptions diagram_options(const std::string& method, const Settings& settings) {
  DiagramOptions options;
  options.method = method == "exact" ? Method::exact : method == "paper" ? Method::paper : Method::gbgvd;
  options.front = method == "paper" ? Front::planar : settings.front;
  options.chord_tolerance = settings.chord_tolerance;
  options.threads = 1;
  return options;
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

/// 0 for a step that the method does not have.
double time_of(const StepTimes& steps, std::string_view name) {
  for (const auto& [step, time] : steps) {
    if (step == name || (step == steps::kFaces && name == steps::kGrowth)) return time;
  }
  return 0;
}

/// Measures the wall-clock times of one and of several threads, and prints the end of a row.
void print_threads(const Mesh& mesh, const std::vector<SurfacePoint>& generators, DiagramOptions options,
                   const Settings& settings) {
  const auto run = [&](int threads) {
    options.threads = threads;
    return wall_milliseconds([&] { compute_diagram(mesh, generators, options); });
  };
  const auto [one, many] = measure_medians(
      settings.runs, [&] { return run(1); }, [&] { return run(settings.threads); });
  std::cout << fmt::format(" | {:>12.1f} {:>12.1f} {:>8.2f}", one, many, one / many);
}

/// Measures and prints one row. The first run, for the memory, also warms up the caches.
void measure(const NamedMesh& input, int count, const std::string& method, const Settings& settings) {
  const Mesh& mesh = input.mesh;
  const std::vector<VertexId> vertices = draw_vertices(mesh, count, settings.seed);
  const std::vector<SurfacePoint> generators = draw_vertex_points(mesh, count, settings.seed);
  DiagramOptions options = diagram_options(method, settings);
  const double bytes = peak_bytes_a_face(mesh, generators, options);
  const EdgeGraph graph = build_edge_graph(mesh);
  StepTimes steps;  // of the last run
  const auto time_dijkstra = [&] { return cpu_milliseconds([&] { compute_edge_distances(graph, vertices); }); };
  const auto time_diagram = [&] {
    StepClock clock;
    options.progress = clock.progress();
    const double time = cpu_milliseconds([&] { compute_diagram(mesh, generators, options); });
    steps = clock.finish();
    return time;
  };
  const auto step = [&](std::size_t column) { return [&, column] { return time_of(steps, kColumns[column]); }; };
  const auto medians = measure_medians(settings.runs, time_dijkstra, time_diagram, step(0), step(1), step(2), step(3));
  const double unit = medians[0];
  std::cout << fmt::format("{:<22} {:>8} {:>5} {:<6} {:>12.3f} {:>9.2f} |", input.name, mesh.face_count(),
                           vertices.size(), method, unit, medians[1] / unit);
  for (std::size_t i = 2; i < medians.size(); ++i) std::cout << fmt::format(" {:>12.2f}", medians[i] / unit);
  std::cout << fmt::format(" | {:>12.0f}", bytes);
  options.progress = {};
  if (settings.threads > 1) print_threads(mesh, generators, options, settings);
  std::cout << std::endl;
}

/// Calls `visit` with every mesh and every number of generators, at every level of refinement.
template <class Visit>
void for_each_row(const Settings& settings, const Visit& visit) {
  for (const std::string& path : settings.meshes) {
    NamedMesh input = read_named_mesh(path);
    const std::string stem = input.name;
    for (int level = 0; level <= settings.refinements; ++level) {
      if (level > 0) input = {fmt::format("{} /{}", stem, 1 << 2 * level), refine_flat(input.mesh)};
      for (const int count : settings.generator_counts) visit(input, count);
    }
    if (!settings.save.empty()) write_mesh(settings.save, {input.mesh});
  }
}

/// A point in the face of p, or in one a few faces further; p is a vertex of the mesh or a point in a face.
SurfacePoint step_from(const Mesh& mesh, const SurfacePoint& p, std::mt19937& random) {
  FaceId f = p.face;
  for (int i = 0; i < kStepFaces; ++i) {
    const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, static_cast<int>(random() % 3)));
    if (twin.valid()) f = Mesh::face(twin);
  }
  const double a = 0.2 + 1e-3 * double(random() % 300), b = 0.1 + 1e-3 * double(random() % 300);
  return make_surface_point(f, {a, b, 1 - a - b});
}

/// Measures moves of generators by some faces, or to random faces, against new diagrams in the same run.
void measure_moves(const NamedMesh& input, int count, const Settings& settings) {
  const Mesh& mesh = input.mesh;
  const DiagramOptions options = diagram_options("exact", settings);
  for (const bool is_far : {false, true}) {
    std::mt19937 random(static_cast<unsigned>(settings.seed) + 1);
    DiagramEditor editor(mesh, draw_vertex_points(mesh, count, settings.seed), options);
    const auto move = [&] {
      const GeneratorId g(random() % editor.generators().size());
      SurfacePoint from = editor.generators()[g.index()];
      if (is_far) from.face = FaceId(random() % static_cast<unsigned>(mesh.face_count()));
      const SurfacePoint to = step_from(mesh, from, random);
      return cpu_milliseconds([&] { editor.move(g, to); });
    };
    for (int i = 0; i < count; ++i) move();  // most generators lie in faces then
    std::int64_t propagated = 0;
    const auto [fresh, moved] = measure_medians(
        settings.moves, [&] { return cpu_milliseconds([&] { compute_diagram(mesh, editor.generators(), options); }); },
        [&] {
          const double time = move();
          propagated += editor.propagated();
          return time;
        });
    std::cout << fmt::format("{:<22} {:>8} {:>5} {:<6} {:>12.2f} {:>10.2f} {:>7.3f} {:>12.1f}\n", input.name,
                             mesh.face_count(), count, is_far ? "far" : "near", fresh, moved, moved / fresh,
                             double(propagated) / settings.moves)
              << std::flush;
  }
}

void run_moves(const Settings& settings) {
  std::cout << fmt::format("\n{:<22} {:>8} {:>5} {:<6} {:>12} {:>10} {:>7} {:>12}\n", "moves", "faces", "m", "kind",
                           "new ms", "move ms", "ratio", "propagated");
  for_each_row(settings, [&](const NamedMesh& input, int count) { measure_moves(input, count, settings); });
}

#ifdef GVD_HAS_PEERS
/// A row of the second table: times at the vertices, without labels or bisectors.
void measure_peers(const NamedMesh& input, int count, const Settings& settings) {
  const Mesh& mesh = input.mesh;
  const std::vector<VertexId> vertices = draw_vertices(mesh, count, settings.seed);
  const EdgeGraph graph = build_edge_graph(mesh);
  PeerTimes times;
  const auto time_dijkstra = [&] { return cpu_milliseconds([&] { compute_edge_distances(graph, vertices); }); };
  const auto time_paths = [&] { return (times = time_peers(mesh, vertices)).shortest_paths; };
  const auto [unit, paths, heat, heat_again] = measure_medians(
      settings.runs, time_dijkstra, time_paths, [&] { return times.heat; }, [&] { return times.heat_again; });
  std::cout << fmt::format("{:<22} {:>8} {:>5} {:>12.3f} | {:>16.1f} {:>8.1f} {:>14.1f}\n", input.name,
                           mesh.face_count(), vertices.size(), unit, paths / unit, heat / unit, heat_again / unit)
            << std::flush;
}
#endif

void run_peers([[maybe_unused]] const Settings& settings) {
#ifdef GVD_HAS_PEERS
  std::cout << fmt::format("\n{:<22} {:>8} {:>5} {:>12} | {:>16} {:>8} {:>14}\n", "CGAL's distances", "faces", "m",
                           "Dijkstra ms", "shortest paths x", "heat x", "heat again x");
  for_each_row(settings, [&](const NamedMesh& input, int count) { measure_peers(input, count, settings); });
#endif
}

void run_all(const Settings& settings) {
  print_header(settings);
  for_each_row(settings, [&](const NamedMesh& input, int count) {
    for (const std::string& method : settings.methods) measure(input, count, method, settings);
  });
  if (settings.moves > 0) run_moves(settings);
  if (settings.peers) run_peers(settings);
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Times the steps of a geodesic Voronoi diagram against a plain Dijkstra on the mesh's edges");
  add_mesh_arguments(app, settings.meshes);
  add_positive(app, "-m,--generators", settings.generator_counts, "numbers of generators");
  add_positive(app, "--runs", settings.runs, "runs; each time is their median");
  app.add_option("--refine", settings.refinements,
                 "also measure the mesh with every face cut in four, up to this many times")
      ->check(CLI::Range(0, 6));
  app.add_option("--save", settings.save, "write the last of these meshes to this file");
  app.add_option("--seed", settings.seed, "seed for drawing the generators");
  add_choice(app, "--method", settings.methods, {"exact", "gbgvd", "paper"},
             "exact, gbgvd, paper, or several (default: exact and gbgvd)");
  add_positive(app, "--chord-tolerance", settings.chord_tolerance,
               "chord tolerance of exact diagrams, in mean edge lengths");
  add_positive(app, "--threads", settings.threads, "also compare the wall-clock times of one thread and of this many");
#ifdef GVD_HAS_PEERS
  app.add_option("--moves", settings.moves, "also time so many near and far moves of a generator")
      ->check(CLI::NonNegativeNumber);
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
