// gvd-compare: the methods that the paper compares itself with, beside ours, one line each.
//
//   gvd-compare [MESH...] [-m 30] [--seed 0] [--runs 1] [--time-factor 1] [--no-unpruned]
//               [--methods "LRVD [28],exact"] [--view PAGE.html]
//
// The generators are random vertices, seeded. Times are processor times of one thread, the medians of the runs:
//   E          the integral of the difference of the exact distances along the bisectors (section 5.2).
//              Infinite where a cell lies on a component that its generator can't reach.
//   turn       radians by which the bisectors turn, for each unit of their length (figure 10)
//   wrong      vertices with another label than a nearest generator
//   islands    components of cells without their generator, and their share of the area
//   forced     faces closed without a rule of the method, or at its cap
//   open       ends of bisectors that nothing continues
//   GDF, VD    milliseconds of the distances, and of the diagram
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <utility>

#include "baseline.hpp"
#include "clocks.hpp"
#include "command_line.hpp"
#include "comparators.hpp"
#include "gvd/error.hpp"
#include "judge.hpp"

namespace gvd::paper {
namespace {

struct Settings {
  std::vector<std::string> meshes;
  int generators = 30;
  std::uint64_t seed = 0;
  int runs = 1;
  ComparatorOptions comparators;
  std::vector<std::string> methods;  ///< all if empty
  std::string view;                  ///< a page with a scene for each method; none if empty
};

void write_view(const std::string& path, const std::string& title, std::vector<ViewScene> scenes) {
  share_neighbours(scenes);
  ViewOptions options;
  options.title = title;
  bench::write_file(path, make_view_page(scenes, options));
}

/// The result of the last run, with the medians of the times.
Comparison run_several(const Comparator& comparator, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                       int runs) {
  Comparison result;
  const auto run = [&] { return (result = comparator.run(mesh, generators)).field_ms; };
  const auto [field, diagram] = bench::measure_medians(runs, run, [&] { return result.diagram_ms; });
  result.field_ms = field;
  result.diagram_ms = diagram;
  return result;
}

void print_header() {
  std::cout << fmt::format("{:<14} {:>10} {:>8} {:>6} {:>10} {:>14} {:>7} {:>5} {:>10} {:>10}\n", "method", "E",
                           "length", "turn", "wrong", "islands", "forced", "open", "GDF ms", "VD ms");
}

/// The line of a method. Shares are of all labelled vertices, and of the area of the mesh.
void print_row(const std::string& name, const Comparison& result, const Judgement& judgement, double area) {
  const Faults& faults = result.faults;
  const std::string islands = fmt::format("{} ({:.2f} %)", faults.islands, 100 * faults.island_area / area);
  const double share = double(judgement.wrong_labels) / double(judgement.labelled);
  const double turn = judgement.turning_angle / judgement.error.length;
  std::cout << fmt::format("{:<14} {:>10.3g} {:>8.2f} {:>6.2f} {:>8.2f} % {:>14} {:>7} {:>5} {:>10.1f} {:>10.1f}\n",
                           name, judgement.error.error_integral, judgement.error.length, turn, 100 * share, islands,
                           faults.forced_faces, faults.open_ends, result.field_ms, result.diagram_ms)
            << std::flush;
}

void compare(const std::string& path, const Settings& settings) {
  const bench::NamedMesh named = bench::read_named_mesh(path);
  const Mesh& mesh = named.mesh;
  const auto generators = bench::draw_vertex_points(mesh, settings.generators, settings.seed);
  std::cout << fmt::format("{}: {} faces, {} generators, seed {}\n", named.name, mesh.face_count(), generators.size(),
                           settings.seed);
  print_header();
  const Judge judge(mesh, generators);
  const double area = compute_mesh_summary(mesh).area;
  std::vector<ViewScene> scenes;
  for (const Comparator& comparator : pick_comparators(settings.methods, settings.comparators)) {
    const Comparison result = run_several(comparator, mesh, generators, settings.runs);
    print_row(comparator.name, result, judge.judge(result.diagram), area);
    if (!settings.view.empty()) scenes.push_back(make_comparison_scene(comparator.name, mesh, result));
  }
  if (!settings.view.empty()) write_view(settings.view, named.name, std::move(scenes));
}

void add_options(CLI::App& app, Settings& settings) {
  bench::add_mesh_arguments(app, settings.meshes);
  bench::add_positive(app, "-m,--generators", settings.generators, "number of generators: random vertices");
  app.add_option("--seed", settings.seed, "seed for drawing the generators");
  bench::add_positive(app, "--runs", settings.runs, "runs; times are their medians");
  bench::add_positive(app, "--time-factor", settings.comparators.diffusion.time_factor,
                      "time step of diffusion, in squared mean edge lengths");
  app.add_option("--methods", settings.methods, "names of methods as the table has them, with commas (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--view", settings.view, "page with a scene for each method; of one mesh only");
}

int run(int argc, char** argv) {
  Settings settings;
  bool no_unpruned = false;
  CLI::App app("Compares the paper's comparators with this library's methods, by E, labels, faults and time");
  add_options(app, settings);
  app.add_flag("--no-unpruned", no_unpruned, "leave out windows of each generator for itself, which need much memory");
  CLI11_PARSE(app, argc, argv);
  settings.comparators.unpruned_windows = !no_unpruned;
  if (!settings.view.empty() && settings.meshes.size() > 1)
    throw Error(ErrorCode::invalid_option, "--view shows one mesh; name one");
  for (const std::string& path : settings.meshes) compare(path, settings);
  return 0;
}

}  // namespace
}  // namespace gvd::paper

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-compare", gvd::paper::run, argc, argv); }
