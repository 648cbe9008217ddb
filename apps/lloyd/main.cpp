// gvd-lloyd: relaxes generators and writes them.
//
// Each iteration moves the generators towards the centroids of their cells, and lowers the energy (gvd/lloyd.hpp). The
// report, the table of --trace and the page tell the iterations in the same words: the name of the step, and that of
// what the energy was measured with. The library reads no clock: RelaxationTrace does, for --trace and --time-limit.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "common/balance.hpp"
#include "common/command.hpp"
#include "common/options/options.hpp"
#include "common/options/shared_options.hpp"
#include "common/referred_files.hpp"
#include "common/relaxation.hpp"
#include "common/run_parts.hpp"
#include "gvd/balance.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/lloyd_options.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// 100,000 generators on 5,876 faces took 76 s of processor time and 0.96 GB.
constexpr GeneratorCost kGeneratorCost{760, 9.6};

const std::vector<std::string> kFormats{"txt",       "csv",       "json", "ply",   "obj", "off",
                                        "coff",      "stl",       "vtp",  "vtu",   "glb", "surf.gii",
                                        "label.gii", "shape.gii", "fs",   "annot", "curv"};

struct OwnOptions : Options {
  LloydOptions relaxation;
  RelaxationStartOptions start;
  ConstraintFiles files;
  std::optional<double> time_limit;  ///< of the relaxation, seconds, >= 0
  std::string balance;               ///< what cells share in the end: "area", a file or a property; empty: as they come
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

void describe_own(OptionList& list, OwnOptions& own) {
  describe_input(list, own.input);
  describe_generators(list, own.generators);
  describe_diagram(list, own.compute);
  describe_output(list, own.output, kFormats);
  describe_no_curves(list, own.output);
  describe_diagram_output(list, own.output);
  describe_target(
      list, own.output, "points", own.points, {"ply", "xyz", "npy"},
      {.help = "Write the generators with normals, barycentric coordinates, areas and energies", .shown = Shown::main});
  describe_target(list, own.output, "trace", own.trace, {"csv"},
                  {.help = "Write energy, moves, methods and seconds of each iteration as CSV"});
  describe(list, own.relaxation);
  describe(list, own.files);
  describe(list, own.start);
  list.group("Relaxation");
  list.option(
      "balance", ValueSource{&own.balance, {"area"}},
      {.help = "In the end, make all cells equal and keep the generators near their centroids",
       .more = ": in area, or in the integral of a number for each vertex or face, out of a file or a property of "
               "{option:input}"});
  list.option("time_limit", Number{&own.time_limit, {.least = 0}},
              {.help = "Stop after the iteration that exceeds this time in all",
               .more = "; the result then varies from run to run",
               .unit = "seconds",
               .usual = "no limit"});
}

const char* describe(LloydStop stop) {
  constexpr std::array<const char*, 6> kSentences{
      "every generator is at its centroid", "the energy falls by less than the tolerance",
      "no step lowers the energy any more", "hardly any decrease of the energy is left",
      "the iterations are used up",         "the time is over"};
  return kSentences[static_cast<std::size_t>(stop)];
}

/// The measure of an iteration's energy: the name of a method, or `sampled` without a diagram.
std::string_view measure_name(const LloydIteration& iteration) {
  return iteration.is_sampled ? "sampled" : name_in(kMethodNames, iteration.method);
}

/// How the step of an iteration was found, in one word.
std::string_view step_name(const LloydIteration& iteration) {
  if (iteration.relocated > 0) return "relocation";
  return iteration.by == Acceleration::none ? "lloyd" : name_in(kAccelerationNames, iteration.by);
}

/// One array for each figure of the iterations. The first energy is that of the given generators.
void add_iterations(Json& results, const LloydResult& result) {
  const auto list = [&](const char* name, const auto& figure) {
    results[name] = Json::array();
    for (const LloydIteration& i : result.iterations) results[name].push_back(std::invoke(figure, i));
  };
  list("energies", &LloydIteration::energy);
  results["energies"].insert(results["energies"].begin(), result.initial_energy);
  list("steps", step_name);
  list("relocated_generators", &LloydIteration::relocated);
  list("methods", measure_name);
  list("largest_moves", &LloydIteration::largest_move);
  list("mean_moves", &LloydIteration::mean_move);
  list("step_scales", &LloydIteration::scale);
  list("held_generators", &LloydIteration::held);
}

/// Standard deviation of the cells' areas, divided by their mean; 0 where they have none.
double area_variation(const IdVector<GeneratorId, Cell>& cells) {
  double sum = 0, squares = 0;
  for (const Cell& cell : cells) sum += cell.area;
  const double mean = sum / static_cast<double>(cells.size());
  if (!(mean > 0)) return 0;
  for (const Cell& cell : cells) squares += (cell.area / mean - 1) * (cell.area / mean - 1);
  return std::sqrt(squares / static_cast<double>(cells.size()));
}

/// When the energy of each iteration was known, and the generators then. The library reads no clock.
class RelaxationTrace {
 public:
  /// Seconds since this was made.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  /// To be called from LloydOptions::on_iteration. Iterations that count as one with those before are forgotten.
  void note(std::int64_t iterations, const std::vector<SurfacePoint>& generators) {
    seconds_.resize(iterations + 1);
    seconds_.back() = seconds();
    generators_.resize(iterations + 1);
    generators_.back() = generators;
  }

  /// The generators after so many iterations; 0: at the start.
  const std::vector<SurfacePoint>& generators(std::size_t iterations) const { return generators_[iterations]; }

  /// A table in CSV: a row for the start, and one for each iteration. `method`: of the run's diagrams.
  /// Only the last column, the seconds since the relaxation began, differs between equal runs.
  void write(std::ostream& out, const LloydResult& result, const Method& method) const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<double> seconds_;                        ///< at the start, and after each iteration
  std::vector<std::vector<SurfacePoint>> generators_;  ///< at the same times
};

void RelaxationTrace::write(std::ostream& out, const LloydResult& result, const Method& method) const {
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

/// Scenes of a page: each costs a diagram, and about as many bytes as a page with one.
constexpr std::size_t kMostScenes = 12;

/// Least chord tolerance between start and end, in mean edge lengths: pages are a quarter smaller than with the
/// default.
constexpr double kCoarseChords = 0.05;

ViewScene make_scene(const Mesh& mesh, const Diagram& diagram, std::string name, double energy) {
  ViewScene scene = make_view_scene(std::move(name), mesh, diagram);
  scene.figures.push_back({"Energy", fmt::format("{:.6g}", energy)});
  return scene;
}

std::string describe_copy_iterations(const CoarseRelaxation& copy) {
  return fmt::format("{}, {} faces", counted(copy.iterations, "iteration", "iterations"), copy.faces);
}

/// The scenes of the page: the relaxed generators, the start, and iterations between them, evenly over the run.
/// `options`: of their diagrams, which are computed but for the last.
std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             DiagramOptions options) {
  const bool has_copy = relaxed.copy.faces > 0;  // then the mesh's iterations may be none, from the end to the end
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

/// The progress of a relaxation that also ends after `limit` seconds.
Progress limit_progress(const Progress& progress, const RelaxationTrace& trace, double limit) {
  return [progress, &trace, limit](std::string_view step, double fraction) {
    return progress(step, std::max(fraction, std::min(1.0, trace.seconds() / limit)));
  };
}

void report_result(Run& run, const LloydResult& result) {
  const double variation = area_variation(result.diagram.cells);
  Json& results = run.report().results();
  results["iterations"] = result.iterations.size();
  results["stop"] = name_in(kLloydStopNames, result.stop);
  add_iterations(results, result);
  results["coarse"] = describe_copy(result.copy);
  results["residual"] = result.residual;
  results["mean_cell_radius"] = result.mean_cell_radius;
  results["diagrams"] = result.diagrams;
  results["area_variation"] = variation;
  run.figures().energy = result.final_energy;
  run.console().note(fmt::format("{}, energy {:.6g} -> {:.6g} mesh units^4: {}",
                                 counted(std::ssize(result.iterations), "iteration", "iterations"),
                                 result.initial_energy, result.final_energy, describe(result.stop)));
  run.console().note(fmt::format("areas of the cells: coefficient of variation {:.3g}", variation));
}

RelaxationStart make_start(Run& run, const CheckedMesh& input, OwnOptions& own) {
  own.start.copy = copy_options(own.relaxation, own.start.copy);
  RelaxationStartOptions options = make_start_options(run, input, own.files, own.start);
  RelaxationStart start;
  {
    StepTimes times(run);
    options.on_step = [&times](std::string_view step) { times.start(step); };
    start = start_relaxation(input.mesh, options);
  }
  report_start(run, input.mesh, start, options);
  return start;
}

LloydResult relax(Run& run, const Mesh& mesh, const RelaxationStart& start, const OwnOptions& own,
                  RelaxationTrace& trace) {
  LloydOptions options = own.relaxation;
  options.diagram = run.options().compute.diagram;
  options.progress = run.progress();
  trace = {};
  if (own.time_limit) {
    options.is_time_over = [&] { return trace.seconds() >= *own.time_limit; };
    options.progress = limit_progress(run.progress(), trace, *own.time_limit);
  }
  options.on_iteration = [&](std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators) {
    trace.note(iterations, generators);
    show_iteration(run, iterations, energy);
  };
  LloydResult result = run.timed("relaxation", [&] { return relax_generators(mesh, start, options); });
  run.console().set_status("");
  note_copy(run, result.copy, start, options.ends_on_copy);
  report_result(run, result);
  return result;
}

/// Makes the cells of a relaxation equal, and takes what that changes into its result.
void balance(Run& run, const CheckedMesh& input, const RelaxationStart& start, const OwnOptions& own,
             LloydResult& relaxed) {
  BalancedRelaxationOptions options;
  if (own.balance != "area") options.balance.density = find_density(run, input, "--balance", own.balance);
  options.balance.diagram = run.options().compute.diagram;
  options.balance.diagram.progress = run.progress();
  options.density = start.density;
  options.freedom = start.freedom;
  options.creases = start.creases;
  BalancedRelaxation found =
      run.timed("balance", [&] { return relax_balanced(input.mesh, relaxed.generators, options); });
  relaxed.generators = found.balanced.diagram.generators;
  relaxed.moments = std::move(found.moments);
  relaxed.final_energy = 0;
  for (const CellMoments& cell : relaxed.moments) relaxed.final_energy += cell.energy;
  run.console().note(fmt::format("{} of balancing, generators at most {:.2g} mean cell radii from their centroids",
                                 counted(found.rounds, "round", "rounds"), found.residual / found.mean_cell_radius));
  report_balance(run, found.balanced);
  relaxed.diagram = std::move(found.balanced.diagram);
  Json& results = run.report().results();
  results["balance"]["rounds"] = found.rounds;
  results["weights"] = relaxed.diagram.weights;
  results["residual"] = found.residual;
  results["mean_cell_radius"] = found.mean_cell_radius;
  results["area_variation"] = area_variation(relaxed.diagram.cells);
  run.figures().energy = relaxed.final_energy;
}

void write_outputs(Run& run, const CheckedMesh& input, const Diagram& diagram) {
  const Mesh& mesh = input.mesh;
  const auto list = [&](GeneratorFormat format) {
    return [&mesh, &diagram, format](std::ostream& out) { out << format_generators(mesh, diagram.generators, format); };
  };
  LabelledMesh output = label_mesh(mesh, diagram, diagram.face_label);
  output.appearance = &input.appearance;
  write_output_files(run, output, {{"txt", list(GeneratorFormat::text)}, {"csv", list(GeneratorFormat::csv)}});
}

void write_points_file(Run& run, const OwnOptions& own, const Mesh& mesh, const LloydResult& relaxed) {
  const auto format = parse_point_format(file_extension(own.points));
  if (!format) return;
  std::vector<SurfaceSample> samples;
  for (const SurfacePoint& point : relaxed.generators) {
    const CellMoments& moments = relaxed.moments[GeneratorId(std::ssize(samples))];
    samples.push_back({point, moments.area, moments.energy});
  }
  write_own_file(run, "--points", [&](std::ostream& out) { write_points(out, mesh, samples, *format); });
}

void lloyd(Run& run, OwnOptions& own) {
  const CheckedMesh input = load_input(run);
  note_many_generators(run, input.mesh, kGeneratorCost);
  check_material_files(run, input.appearance);
  const Mesh& mesh = input.mesh;
  const RelaxationStart start = make_start(run, input, own);
  RelaxationTrace trace;
  LloydResult relaxed = relax(run, mesh, start, own, trace);
  if (!own.balance.empty()) balance(run, input, start, own, relaxed);
  run.report().generators().clear();
  run.report().set_generators(mesh, relaxed.generators);
  report_diagram(run, relaxed.diagram);
  write_outputs(run, input, relaxed.diagram);
  write_diagram_file(run, mesh, relaxed.diagram);
  write_points_file(run, own, mesh, relaxed);
  write_own_file(run, "--trace",
                 [&](std::ostream& out) { trace.write(out, relaxed, run.options().compute.diagram.method); });
  write_view_file(run, "gvd-lloyd", [&] {
    DiagramOptions early = run.options().compute.diagram;
    early.progress = run.progress();
    return make_iteration_scenes(mesh, relaxed, trace, early);
  });
  resolve(own.relaxation);  // for the report
  finish_run(run, mesh, relaxed.diagram);
}

}  // namespace

Command lloyd_command() {
  return make_command<OwnOptions>({"gvd-lloyd",
                                   "Moves generators to the geodesic centroids of their cells until they stop moving.",
                                   kExamples,
                                   {kFormats}},
                                  {describe_own, lloyd});
}

}  // namespace gvd::app
