// gvd-bench-lloyd: what relaxations cost, and how low their energies get, beside the goals that are set for them.
//
// Times are processor times of one thread, and those of the generators' drawing are not included. E is measured with
// exact distances. The plain Dijkstra of the same mesh and number of generators is the yardstick for other machines.
// The parts ask one question each:
//   energies   how low E gets, and how soon: the time of the shortest run whose result has at most a given E. The trace
//              shows E as the relaxation saw it, which is approximate in early iterations
//   iteration  what an iteration costs in diagrams. One diagram is the least possible cost; the rest are integrals,
//              moves, and diagrams that the line search throws away
//   threads    how much faster several threads are in wall-clock time
//   large      how soon a mesh with four times the faces comes within 1 % of its last energy
//   square     how near E comes to the honeycomb's, the least one possible on a plane (L. Fejes Toth 1953)
// A goal is printed beside the figure that it is for. A missed goal is no error: the status is 0.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "baseline.hpp"
#include "clocks.hpp"
#include "command_line.hpp"
#include "gvd/sampling.hpp"
#include "relaxation_run.hpp"

namespace gvd::bench {
namespace {

struct Settings {
  std::vector<std::string> meshes;
  std::string large;  ///< path of a mesh that is refined once; may be empty
  std::vector<int> generator_counts{100, 1000};
  std::vector<std::string> starts{"farthest", "random"};
  std::vector<std::string> parts{"energies", "iteration", "threads", "large", "square"};
  std::vector<double> targets{0.1650, 0.1638, 0.1630};
  int iterations = 60;
  int short_iterations = 10;  ///< of the runs that measure one iteration
  int runs = 3;
  int threads = 2;
  int square = 150;
  int square_generators = 2000;

  bool has(const char* part) const { return contains(parts, part); }
};

/// The seconds in which runs from the farthest points have to get to E.
struct Goal {
  int generators;
  double energy, seconds;
};
constexpr Goal kGoals[]{{100, 0.1650, 1.2}, {100, 0.1630, 4}, {1000, 0.1638, 2}, {1000, 0.1630, 6}};
constexpr double kIterationGoal = 1.3;       ///< diagrams
constexpr double kThreadsGoal = 1.7;         ///< two threads are this much faster
constexpr double kLargeGoal = 8;             ///< seconds to within kClose of the last energy
constexpr double kClose = 1.01;              ///< as a factor of the energy
constexpr double kHoneycomb = 0.1603750748;  ///< 5 / (18 sqrt(3))
constexpr int kFirstIterations = 5;          ///< that are not among those whose cost is measured
constexpr double kMargin = 4;                ///< cell widths at the boundary of the square that are left out

const char* verdict(bool met) { return met ? "met" : "missed"; }

std::vector<SurfacePoint> draw(const Mesh& mesh, int count, const std::string& start) {
  SamplingOptions options;
  options.kind = start == "random" ? Sampling::random : Sampling::farthest;
  options.count = count;
  return sample_generators(mesh, options);
}

/// The energies of the first iterations and of every tenth: they fall fast first, and then by thousandths.
void print_trace(const RelaxationRun& run) {
  std::cout << "  iteration (seconds, E):";
  for (std::size_t i = 0; i < run.trace.size(); ++i) {
    const TracePoint& point = run.trace[i];
    const bool is_last = i + 1 == run.trace.size();
    // An energy that is measured anew replaces the one before.
    if (!is_last && run.trace[i + 1].iteration == point.iteration) continue;
    const int k = point.iteration;
    if (is_last || k <= 3 || k == 5 || k % 10 == 0) {
      std::cout << fmt::format(" {} ({:.2f}, {:.4f})", k, point.seconds, point.energy);
    }
  }
  std::cout << "\n";
}

/// Ends the line of a target, with the goal where one is set for it.
void print_goal(double energy, int generators, const std::string& start, double seconds) {
  for (const Goal& goal : kGoals) {
    if (start != "farthest" || goal.generators != generators || goal.energy != energy) continue;
    std::cout << fmt::format("   goal {:.1f} s: {}", goal.seconds, verdict(seconds <= goal.seconds));
  }
  std::cout << std::endl;
}

/// Prints E and the time of a whole run, its trace, and the shortest run to each target.
void measure_energies(const Mesh& mesh, int count, const std::string& start, const Settings& settings) {
  const std::vector<SurfacePoint> generators = draw(mesh, count, start);
  const double unit = dijkstra_seconds(mesh, count, settings.runs);
  LloydOptions options;
  options.max_iterations = settings.iterations;
  const RelaxationRun run = run_relaxation(mesh, generators, options);
  std::cout << fmt::format("m = {}, {}: Dijkstra {:.4f} s; {} iterations, {} diagrams, {:.2f} s, E = {:.5f}\n", count,
                           start, unit, run.result.iterations.size(), run.result.diagrams, run.seconds, run.energy);
  print_trace(run);
  for (const double target : settings.targets) {
    const auto shortest = shortest_run_to(target, mesh, generators, run.trace, settings.runs);
    std::cout << fmt::format("  E <= {:.4f}:", target);
    if (shortest) {
      std::cout << fmt::format(" {:3} iterations, {:6.2f} s ({:.0f} x), E = {:.5f}", shortest->iterations,
                               shortest->seconds, shortest->seconds / unit, shortest->energy);
    } else {
      std::cout << fmt::format(" not in {} iterations", run.result.iterations.size());
    }
    print_goal(target, count, start, shortest ? shortest->seconds : HUGE_VAL);
  }
}

/// A run whose iterations all have exact diagrams, from the first one on; or only the last ones.
RelaxationRun run_iterations(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int iterations,
                             bool early_approximation = false) {
  LloydOptions options;
  options.max_iterations = iterations;
  return run_relaxation(mesh, generators, options, {.early_approximation = early_approximation});
}

/// Mean seconds of the iterations without diagrams but the first one, at which generators leave vertices.
double seconds_of_early_iteration(const Mesh& mesh, int count, const Settings& settings) {
  const RelaxationRun run = run_iterations(mesh, draw(mesh, count, "farthest"), settings.short_iterations, true);
  double first = 0, last = 0;
  int iterations = 0;
  for (const TracePoint& point : run.trace) {
    if (point.iteration == 1) first = point.seconds;
    if (point.iteration <= iterations || point.iteration == settings.short_iterations) continue;
    iterations = point.iteration;
    last = point.seconds;
  }
  return (last - first) / std::max(1, iterations - 1);
}

/// Prints what an iteration costs in diagrams: an exact one, and one of those that approximate.
void measure_iteration(const Mesh& mesh, int count, const Settings& settings) {
  // Farthest points are vertices, where it is tested once whether they rest: only later iterations are like all others.
  const std::vector<SurfacePoint> generators =
      run_iterations(mesh, draw(mesh, count, "farthest"), kFirstIterations).result.generators;
  DiagramOptions options;
  options.threads = 1;
  RelaxationRun some;
  double made = 1, start = 0;  // iterations of a run; seconds of one without iterations: a diagram and its integrals
  const auto time_start = [&] { return start = run_iterations(mesh, generators, 0).seconds; };
  const auto time_iteration = [&] {
    some = run_iterations(mesh, generators, settings.short_iterations);
    made = double(std::max<std::size_t>(1, some.result.iterations.size()));
    return (some.seconds - start) / made;
  };
  const auto time_diagram = [&] {
    return cpu_milliseconds([&] { compute_diagram(mesh, some.result.generators, options); }) / 1e3;
  };
  const auto time_early = [&] { return seconds_of_early_iteration(mesh, count, settings); };
  const auto [evaluation, iteration, unit, early] =
      measure_medians(settings.runs, time_start, time_iteration, time_diagram, time_early);
  std::cout << fmt::format(
      "m = {}: a diagram {:.3f} s; with its integrals {:.2f} diagrams; an early iteration {:.2f}   goal {:.1f}: {}; an "
      "exact iteration {:.2f}, of which it computes {:.2f}   goal {:.1f}: {}\n",
      count, unit, evaluation / unit, early / unit, kIterationGoal, verdict(early / unit <= kIterationGoal),
      iteration / unit, double(some.result.diagrams - 1) / made, kIterationGoal,
      verdict(iteration / unit <= kIterationGoal));
}

/// Prints the wall-clock times of one and of several threads.
void measure_threads(const Mesh& mesh, int count, const Settings& settings) {
  const std::vector<SurfacePoint> generators = draw(mesh, count, "farthest");
  const auto seconds = [&](int threads) {
    LloydOptions options;
    options.max_iterations = settings.short_iterations;
    options.diagram.threads = threads;
    return wall_milliseconds([&] { relax_generators(mesh, generators, options); }) / 1e3;
  };
  const auto [one, many] = measure_medians(
      settings.runs, [&] { return seconds(1); }, [&] { return seconds(settings.threads); });
  const double gain = one / many;
  std::cout << fmt::format("m = {}: {:.2f} s of wall-clock time with one thread, {:.2f} s with {}: {:.2f} times faster",
                           count, one, many, settings.threads, gain);
  if (settings.threads == 2) {
    std::cout << fmt::format("   goal {:.1f}: {}", kThreadsGoal, verdict(gain >= kThreadsGoal));
  }
  std::cout << std::endl;
}

/// Prints a run on the refined mesh, and the shortest one to nearly the same energy.
void measure_large(const Settings& settings) {
  const auto [name, coarse] = read_named_mesh(settings.large);
  const Mesh mesh = refine_flat(coarse);
  const int count = settings.generator_counts.back();
  const std::vector<SurfacePoint> generators = draw(mesh, count, "farthest");
  LloydOptions options;
  options.max_iterations = settings.iterations;
  const RelaxationRun run = run_relaxation(mesh, generators, options);
  std::cout << fmt::format(
      "{}, refined once: {} faces, m = {}, farthest: Dijkstra {:.4f} s; {} iterations, {:.2f} s, E = {:.5f}\n", name,
      mesh.face_count(), count, dijkstra_seconds(mesh, count, settings.runs), run.result.iterations.size(), run.seconds,
      run.energy);
  print_trace(run);
  if (const auto shortest = shortest_run_to(kClose * run.energy, mesh, generators, run.trace, settings.runs)) {
    std::cout << fmt::format("  within 1 % of that: {} iterations, {:.2f} s, E = {:.5f}   goal {:.1f} s: {}\n",
                             shortest->iterations, shortest->seconds, shortest->energy, kLargeGoal,
                             verdict(shortest->seconds <= kLargeGoal));
  }
}

/// Prints E of the interior of the flat square, from each start.
void measure_square(const Settings& settings) {
  const Mesh mesh = make_flat_square(settings.square);
  for (const std::string& start : settings.starts) {
    const std::vector<SurfacePoint> generators = draw(mesh, settings.square_generators, start);
    const RelaxationRun run = run_relaxation(mesh, generators, {});
    const InteriorEnergy interior = interior_energy(mesh, settings.square, run.result.diagram, kMargin);
    const double excess = interior.energy / kHoneycomb - 1;
    std::cout << fmt::format(
                     "flat square, {} faces, m = {}, {}: {} iterations, {:.1f} s; {} interior cells, E = {:.5f}, "
                     "{:.2f} % above the "
                     "honeycomb   goal 1 %: {}\n",
                     mesh.face_count(), settings.square_generators, start, run.result.iterations.size(), run.seconds,
                     interior.cells, interior.energy, 100 * excess, verdict(excess <= kClose - 1))
              << std::flush;
  }
}

void measure_mesh(const Mesh& mesh, const Settings& settings) {
  for (const int count : settings.generator_counts) {
    for (const std::string& start : settings.starts) {
      if (settings.has("energies")) measure_energies(mesh, count, start, settings);
    }
  }
  for (const int count : settings.generator_counts) {
    if (settings.has("iteration")) measure_iteration(mesh, count, settings);
    if (settings.has("threads")) measure_threads(mesh, count, settings);
  }
}

void run_all(const Settings& settings) {
  if (settings.has("energies") || settings.has("iteration") || settings.has("threads")) {
    for (const std::string& path : settings.meshes) {
      const auto [name, mesh] = read_named_mesh(path);
      std::cout << fmt::format("{}: {} faces\n", name, mesh.face_count());
      measure_mesh(mesh, settings);
    }
  }
  if (settings.has("large") && !settings.large.empty()) measure_large(settings);
  if (settings.has("square")) measure_square(settings);
}

void add_options(CLI::App& app, Settings& settings) {
  add_mesh_arguments(app, settings.meshes);
  app.add_option("--large", settings.large,
                 "a mesh that is refined once and relaxed with the last number of generators")
      ->check(CLI::ExistingFile);
  add_positive(app, "-m,--generators", settings.generator_counts, "numbers of generators");
  add_choice(app, "--starts", settings.starts, settings.starts, "farthest, random, or both");
  add_choice(app, "--parts", settings.parts, settings.parts,
             "energies, iteration, threads, large, square, or several (default: all)");
  app.add_option("--targets", settings.targets, "values of E, to which the times are measured")->delimiter(',');
  add_positive(app, "--iterations", settings.iterations, "largest number of iterations");
  add_positive(app, "--runs", settings.runs, "runs; each time is their median");
  add_positive(app, "--threads", settings.threads, "threads to compare with one");
  add_positive(app, "--square", settings.square, "the flat square has this many squares along each side");
  add_positive(app, "--square-generators", settings.square_generators, "generators on the flat square");
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Times relaxations of gvd-lloyd, and measures how low their energies get");
  add_options(app, settings);
  CLI11_PARSE(app, argc, argv);
  run_all(settings);
  return 0;
}

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-bench-lloyd", gvd::bench::run, argc, argv); }
