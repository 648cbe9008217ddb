// What gvd-lloyd tells of a relaxation: members of the report, notes, the table of --trace, and the scenes of --view.
//
// Iterations are told in several places by the same words: the step's name (Acceleration, "lloyd", "relocation") and
// the name of what the energy was measured with. Energies are in mesh units to the fourth. The scenes between start and
// end are diagrams of their own, with coarse chords.

#include "lloyd/lloyd_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <ostream>

#include "common/options/options_json.hpp"
#include "common/relaxation.hpp"
#include "gvd/counted.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

const char* describe(LloydStop stop) {
  constexpr std::array<const char*, 5> kSentences{
      "every generator is at its centroid", "the energy falls by less than the tolerance",
      "no step lowers the energy any more", "the iterations are used up", "the time is over"};
  return kSentences[static_cast<std::size_t>(stop)];
}

/// The name of an acceleration as on the command line.
const std::string& name_of(Acceleration acceleration) {
  const auto has_value = [acceleration](const auto& choice) { return choice.second == acceleration; };
  return std::find_if(acceleration_names().begin(), acceleration_names().end(), has_value)->first;
}

/// What the energy of an iteration was measured with: the name of a method, or `sampled` without a diagram.
const char* measure_name(const LloydIteration& iteration) {
  return iteration.is_sampled ? "sampled" : method_name(iteration.method);
}

/// How the step of an iteration was found, in one word.
std::string step_name(const LloydIteration& iteration) {
  if (iteration.relocated > 0) return "relocation";
  return iteration.by == Acceleration::none ? "lloyd" : name_of(iteration.by);
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

/// Scenes of a page: each costs a diagram, and about as many bytes as a page with one.
constexpr std::size_t kMostScenes = 12;

/// Least chord tolerance between start and end, in mean edge lengths: pages are a quarter smaller than with the
/// default.
constexpr double kCoarseChords = 0.05;

DiagramOptions coarse(DiagramOptions options) {
  options.chord_tolerance = std::max(kCoarseChords, options.chord_tolerance);
  return options;
}

ViewScene make_scene(const Mesh& mesh, const Diagram& diagram, std::string name, double energy) {
  ViewScene scene = make_view_scene(std::move(name), mesh, diagram);
  scene.figures.push_back({"Energy", fmt::format("{:.6g}", energy)});
  return scene;
}

double energy_after(const LloydResult& relaxed, std::size_t iterations) {
  return iterations == 0 ? relaxed.initial_energy : relaxed.iterations[iterations - 1].energy;
}

}  // namespace

const std::vector<std::pair<std::string, Acceleration>>& acceleration_names() {
  static const std::vector<std::pair<std::string, Acceleration>> names{
      {"lbfgs", Acceleration::lbfgs}, {"anderson", Acceleration::anderson}, {"none", Acceleration::none}};
  return names;
}

void report_own_options(Json& reported, const OwnOptions& own) {
  const LloydOptions& options = own.relaxation;
  reported["accelerate"] = name_of(options.acceleration);
  reported["relocate"] = relocates(options);
  reported["iterations"] = max_iterations(options);
  reported["tolerance"] = energy_tolerance(options);
  reported["move_tolerance"] = options.move_tolerance;
  reported["step"] = options.step;
  report_constraints(reported, own.constraints);
  reported["time_limit"] = own.time_limit ? Json(*own.time_limit) : Json();
}

void report_relaxation(Json& results, const LloydResult& result) {
  results["iterations"] = result.iterations.size();
  results["stop"] = name_of(result.stop);
  add_iterations(results, result);
  results["residual"] = result.residual;
  results["mean_cell_radius"] = result.mean_cell_radius;
  results["diagrams"] = result.diagrams;
  results["area_variation"] = area_variation(result.diagram.cells);
}

std::vector<std::string> describe_relaxation(const LloydResult& result) {
  return {fmt::format("{}, energy {:.6g} -> {:.6g} mesh units^4: {}",
                      counted(std::ssize(result.iterations), "iteration", "iterations"), result.initial_energy,
                      result.final_energy, describe(result.stop)),
          fmt::format("areas of the cells: coefficient of variation {:.3g}", area_variation(result.diagram.cells))};
}

void RelaxationTrace::note(std::int64_t iterations, const std::vector<SurfacePoint>& generators) {
  seconds_.resize(iterations + 1);
  seconds_.back() = seconds();
  generators_.resize(iterations + 1);
  generators_.back() = generators;
}

void RelaxationTrace::write(std::ostream& out, const LloydResult& result, const Method& method) const {
  out << "iteration,energy,largest_move,mean_move,method,step,seconds\n";
  const char* first = result.iterations.empty() ? method_name(method) : measure_name(result.iterations.front());
  out << fmt::format("0,{},0,0,{},start,{:.6f}\n", result.initial_energy, first, seconds_.front());
  for (std::size_t i = 0; i < result.iterations.size(); ++i) {
    const LloydIteration& done = result.iterations[i];
    out << fmt::format("{},{},{},{},{},{},{:.6f}\n", i + 1, done.energy, done.largest_move, done.mean_move,
                       measure_name(done), step_name(done), seconds_[i + 1]);
  }
}

std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             const DiagramOptions& options) {
  const std::size_t last = relaxed.iterations.size(), gaps = std::min(kMostScenes - 1, std::max<std::size_t>(last, 1));
  std::vector<ViewScene> scenes{make_scene(mesh, relaxed.diagram, "Relaxed", relaxed.final_energy)};
  scenes[0].figures.push_back({"Iterations", fmt::format("{}", last)});
  scenes[0].figures.push_back({"Stopped by", name_of(relaxed.stop)});
  if (last > 0) scenes[0].iteration = last;
  for (std::size_t k = 0; k < gaps; ++k) {
    const std::size_t iterations = (k * last + gaps / 2) / gaps;  // rounded to the nearest
    const Diagram diagram = compute_diagram(mesh, trace.generators(iterations), k == 0 ? options : coarse(options));
    scenes.push_back(make_scene(mesh, diagram, k == 0 ? "Start" : "", energy_after(relaxed, iterations)));
    if (last > 0) scenes.back().iteration = iterations;
  }
  return scenes;
}

}  // namespace gvd::app
