// gvd-lloyd: relaxes generators and writes them.
//
// The library moves the generators (gvd/lloyd_operation.hpp). The report, the table of --trace and the page describe
// iterations in the same words: how the step was found, and how the energy was measured. The library reads no clock;
// RelaxationTrace does, for --trace and --time-limit.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "common/command.hpp"
#include "common/load_input.hpp"
#include "common/options/options.hpp"
#include "common/options/shared_options.hpp"
#include "common/referred_files.hpp"
#include "common/run_parts.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/lloyd_operation.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

/// 100,000 generators on 5,876 faces took 76 s of processor time and 0.96 GB.
constexpr GeneratorCost kGeneratorCost{760, 9.6};

const std::vector<std::string> kFormats = output_extensions(LloydOutcome::kContent);

struct LloydCommandOptions : Options {
  LloydCall call;
  std::optional<double> time_limit;  ///< for the relaxation, seconds, >= 0
  std::string points, trace;         ///< files; empty: none
};

constexpr const char* kExamples =
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt\n"
    "  gvd-lloyd bunny.obj --generators samples.csv --iterations 200 -o relaxed.json\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt -o cells.ply --view cells.html\n"
    "  gvd-lloyd bunny.obj -n 100 --time-limit 5 --points samples.ply\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt &&\n"
    "    gvd-remesh bunny.obj --generators relaxed.txt -o coarse.obj\n"
    "  gvd-lloyd scans/*.stl -n 30 --output-dir relaxed --output-format json\n";

void describe_own(OptionList& list, LloydCommandOptions& own) {
  describe_input(list, own.input);
  describe(list, own.call);
  describe_generators_format(list, own.input);
  describe_resources(list, own.compute);
  describe_verify(list, own.compute);
  list.group("Relaxation");
  list.option("time_limit", Number{&own.time_limit, {.least = 0}},
              {.help = "Stop after the iteration that exceeds this time in all",
               .more = "; the result then varies from run to run",
               .unit = "seconds",
               .usual = "no limit"});
  describe_output(list, own.output, kFormats, "txt");
  describe_no_curves(list, own.output);
  describe_diagram_output(list, own.output);
  const std::vector<std::string_view> names = names_in(kPointFormatNames);
  describe_target(
      list, own.output, "points", own.points, {names.begin(), names.end()},
      {.help = "Write the generators with normals, barycentric coordinates, areas and energies", .shown = Shown::main});
  describe_target(list, own.output, "trace", own.trace, {"csv"},
                  {.help = "Write energy, moves, methods and seconds of each iteration as CSV"});
}

/// Records for each iteration the generators, and the time at which its energy was known.
class RelaxationTrace {
 public:
  /// Seconds since this object was made or restarted.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  void restart() { *this = {}; }

  /// Call it from LloydOptions::on_iteration. Iterations that were merged with earlier ones are forgotten.
  void note(std::int64_t iterations, const std::vector<SurfacePoint>& generators) {
    seconds_.resize(iterations + 1);
    seconds_.back() = seconds();
    generators_.resize(iterations + 1);
    generators_.back() = generators;
  }

  /// The generators after this many iterations; 0: at the start.
  const std::vector<SurfacePoint>& generators(std::size_t iterations) const { return generators_[iterations]; }

  /// Writes a table in CSV with a row for the start and for each iteration. `method`: the method of the run's diagrams.
  /// Only the last column, the seconds since the relaxation began, differs between equal runs.
  void write(std::ostream& out, const LloydResult& result, const Method& method) const {
    out << "iteration,energy,largest_move,mean_move,method,step,seconds\n";
    const std::string_view first =
        result.iterations.empty() ? name_in(kMethodNames, method) : measure_name(result.iterations.front());
    out << fmt::format("0,{},0,0,{},start,{:.6f}\n", result.initial_energy, first, seconds_.front());
    for (std::size_t i = 0; i < result.iterations.size(); ++i) {
      const LloydIteration& done = result.iterations[i];
      out << fmt::format("{},{},{},{},{},{},{:.6f}\n", i + 1, done.energy, done.largest_move, done.mean_move,
                         measure_name(done), step_name(done), seconds_[i + 1]);
    }
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<double> seconds_;                        ///< at the start, and after each iteration
  std::vector<std::vector<SurfacePoint>> generators_;  ///< at the same times
};

/// Largest number of scenes in a page. Each costs a diagram, and makes the page larger by about the size of a page with
/// one scene.
constexpr std::size_t kMostScenes = 12;

/// Least chord tolerance of scenes between start and end, in mean edge lengths. Pages become a quarter smaller than
/// with the default.
constexpr double kCoarseChords = 0.05;

ViewScene make_scene(const Mesh& mesh, const Diagram& diagram, std::string name, double energy) {
  ViewScene scene = make_view_scene(std::move(name), mesh, diagram);
  scene.figures.push_back({"Energy", fmt::format("{:.6g}", energy)});
  return scene;
}

std::string describe_copy_iterations(const CoarseRelaxation& copy) {
  return fmt::format("{}, {} faces", counted(copy.iterations, "iteration", "iterations"), copy.faces);
}

/// Makes the scenes of the page: the relaxed generators, the start, and iterations between them, evenly spread over the
/// run. `options`: for the diagrams, all of which are computed here except the last.
std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             DiagramOptions options) {
  const bool has_copy = relaxed.copy.faces > 0;  // then there may be no iterations on the mesh
  const std::size_t last = relaxed.iterations.size();
  const std::size_t gaps = std::min(kMostScenes - 1, std::max<std::size_t>(last, has_copy ? 0 : 1));
  std::vector<ViewScene> scenes{make_scene(mesh, relaxed.diagram, "Relaxed", relaxed.final_energy)};
  scenes[0].figures.push_back({"Iterations", fmt::format("{}", last)});
  scenes[0].figures.push_back({"Stopped by", std::string(name_in(kLloydStopNames, relaxed.stop))});
  if (has_copy) scenes[0].figures.push_back({"On a coarse copy", describe_copy_iterations(relaxed.copy)});
  if (last > 0) scenes[0].iteration = last;
  for (std::size_t k = 0; k < gaps; ++k) {
    const std::size_t done = (k * last + gaps / 2) / gaps;  // rounded to the nearest
    const double energy = done == 0 ? relaxed.initial_energy : relaxed.iterations[done - 1].energy;
    const Diagram diagram = compute_diagram(mesh, trace.generators(done), options);
    scenes.push_back(make_scene(mesh, diagram, k > 0 ? "" : has_copy ? "From the copy" : "Start", energy));
    if (last > 0) scenes.back().iteration = done;
    options.chord_tolerance = std::max(kCoarseChords, options.chord_tolerance);
  }
  return scenes;
}

/// The observer of a relaxation, which also ends it after a time limit.
class TimedObserver : public RunObserver {
 public:
  TimedObserver(Run& run, RelaxationTrace& trace, std::optional<double> limit)
      : RunObserver(run), trace_(trace), limit_(limit) {}
  bool progress(std::string_view step, double fraction) override {
    if (limit_ && relaxes_) fraction = std::max(fraction, std::min(1.0, trace_.seconds() / *limit_));
    return RunObserver::progress(step, fraction);
  }
  void enter(std::string_view step) override {
    RunObserver::enter(step);
    relaxes_ = step == kRelaxationStep;
    if (relaxes_) trace_.restart();
  }
  void leave() override {
    relaxes_ = false;
    RunObserver::leave();
  }

 private:
  RelaxationTrace& trace_;
  std::optional<double> limit_;
  bool relaxes_ = false;
};

void lloyd(Run& run, LloydCommandOptions& own) {
  const MeshPtr input = load_input(run);
  note_many_generators(run, input->mesh, own.call.generators.wanted().value_or(0), kGeneratorCost);
  check_material_files(run, input->appearance);
  const Mesh& mesh = input->mesh;
  RelaxationTrace trace;
  own.call.relaxation.on_iteration = [&trace](std::int64_t iterations, double, const auto& generators) {
    trace.note(iterations, generators);
  };
  if (own.time_limit) own.call.relaxation.is_time_over = [&] { return trace.seconds() >= *own.time_limit; };
  const auto outcome = [&] {
    TimedObserver observer(run, trace, own.time_limit);
    return gvd::run(input, own.call, observer);
  }();
  const LloydResult& relaxed = *outcome->relaxed;
  const Mesh& surface = outcome->diagram->surface();
  report_figures(run, *outcome);
  run.report().at("results")["final_energy"] = relaxed.final_energy;  // for the table of several inputs, too
  report_generators(run, mesh, relaxed.generators, outcome->snap_distance);
  run.report().set_diagram(relaxed.diagram);
  write_output_files(run, *outcome);
  write_diagram_file(run, mesh, outcome->diagram->diagram());
  write_part_file(run, "points", *outcome);
  write_own_file(run, "trace", [&](std::ostream& out) { trace.write(out, relaxed, own.call.diagram.method); });
  write_view_file(run, "gvd-lloyd", [&] {
    DiagramOptions early = own.call.diagram;
    early.progress = run.progress();
    return make_iteration_scenes(surface, relaxed, trace, early);
  });
  finish_run(run, surface, relaxed.diagram);
}

}  // namespace

Command lloyd_command() {
  return make_command<LloydCommandOptions>(
      {"gvd-lloyd",
       "Moves generators to the geodesic centroids of their cells until they stop moving.",
       kExamples,
       {kFormats}},
      {describe_own, lloyd});
}

}  // namespace gvd::app
