#include "lloyd/lloyd_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/options/options_json.hpp"
#include "common/relaxation/relaxation_report.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

const char* describe(LloydStop stop) {
  switch (stop) {
    case LloydStop::centroids:
      return "every generator is at its centroid";
    case LloydStop::energy:
      return "the energy falls by less than the tolerance";
    case LloydStop::no_descent:
      return "no step lowers the energy any more";
    case LloydStop::max_iterations:
      return "the iterations are used up";
    case LloydStop::time_limit:
      return "the time is over";
  }
  return "";
}

/// The name of an acceleration as on the command line.
const std::string& name_of(Acceleration acceleration) {
  const auto has_value = [acceleration](const auto& choice) { return choice.second == acceleration; };
  return std::find_if(acceleration_names().begin(), acceleration_names().end(), has_value)->first;
}

/// One array for each figure of the iterations. The first energy is that of the given generators.
void add_iterations(Json& results, const LloydResult& result) {
  Json energies = Json::array({result.initial_energy});
  Json steps = Json::array(), methods = Json::array(), relocated = Json::array();
  Json largest = Json::array(), mean = Json::array(), scales = Json::array(), held = Json::array();
  for (const LloydIteration& i : result.iterations) {
    energies.push_back(i.energy);
    largest.push_back(i.largest_move);
    mean.push_back(i.mean_move);
    scales.push_back(i.scale);
    held.push_back(i.held);
    methods.push_back(measure_name(i));
    steps.push_back(step_name(i));
    relocated.push_back(i.relocated);
  }
  results["energies"] = std::move(energies);
  results["steps"] = std::move(steps);
  results["relocated_generators"] = std::move(relocated);
  results["methods"] = std::move(methods);
  results["largest_moves"] = std::move(largest);
  results["mean_moves"] = std::move(mean);
  results["step_scales"] = std::move(scales);
  results["held_generators"] = std::move(held);
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

}  // namespace

const char* measure_name(const LloydIteration& iteration) {
  return iteration.is_sampled ? "sampled" : method_name(iteration.method);
}

std::string step_name(const LloydIteration& iteration) {
  if (iteration.relocated > 0) return "relocation";
  return iteration.by == Acceleration::none ? "lloyd" : name_of(iteration.by);
}

const Choices<Acceleration>& acceleration_names() {
  static const Choices<Acceleration> names{
      {"lbfgs", Acceleration::lbfgs}, {"anderson", Acceleration::anderson}, {"none", Acceleration::none}};
  return names;
}

void report_lloyd_options(Run& run, const OwnOptions& own) {
  const LloydOptions& options = own.relaxation;
  Json& reported = run.report().options();
  reported["accelerate"] = name_of(options.acceleration);
  reported["relocate"] = relocates(options);
  reported["iterations"] = max_iterations(options);
  reported["tolerance"] = energy_tolerance(options);
  reported["move_tolerance"] = options.move_tolerance;
  reported["step"] = options.step;
  report_constraints(reported, own.constraints);
  reported["time_limit"] = own.time_limit ? Json(*own.time_limit) : Json();
}

void report_relaxation(Run& run, const Mesh& mesh, const LloydResult& result) {
  Json& results = run.report().results();
  results["iterations"] = result.iterations.size();
  results["stop"] = name_of(result.stop);
  add_iterations(results, result);
  results["residual"] = result.residual;
  results["mean_cell_radius"] = result.mean_cell_radius;
  results["diagrams"] = result.diagrams;
  const double variation = area_variation(result.diagram.cells);
  results["area_variation"] = variation;
  run.figures().energy = result.final_energy;
  run.console().note(fmt::format("{}, energy {:.6g} -> {:.6g} mesh units^4: {}",
                                 counted(std::ssize(result.iterations), "iteration", "iterations"),
                                 result.initial_energy, result.final_energy, describe(result.stop)));
  run.console().note(fmt::format("areas of the cells: coefficient of variation {:.3g}", variation));
  run.report().generators().clear();
  for (const SurfacePoint& p : result.generators) {
    run.report().generators().push_back({p, position(mesh, p), std::nullopt});
  }
}

}  // namespace gvd::app
