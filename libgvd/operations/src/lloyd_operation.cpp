// The operation `lloyd`: chooses and relaxes generators and, if the options ask for it, balances their cells.
//
// Each iteration moves the generators towards the centroids of their cells, and lowers the energy (gvd/lloyd.hpp).

#include "gvd/lloyd_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "figures.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/diagram_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/lloyd_options.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

const char* describe(LloydStop stop) {
  constexpr std::array<const char*, 6> kSentences{
      "every generator is at its centroid", "the energy falls by less than the tolerance",
      "no step lowers the energy any more", "converged",
      "the iteration limit was reached",    "the time limit was reached"};
  return kSentences[static_cast<std::size_t>(stop)];
}

/// The standard deviation of the cells' areas, divided by their mean; 0 if they have no area.
double area_variation(const IdVector<GeneratorId, Cell>& cells) {
  double sum = 0, squares = 0;
  for (const Cell& cell : cells) sum += cell.area;
  const double mean = sum / static_cast<double>(cells.size());
  if (!(mean > 0)) return 0;
  for (const Cell& cell : cells) squares += (cell.area / mean - 1) * (cell.area / mean - 1);
  return std::sqrt(squares / static_cast<double>(cells.size()));
}

/// Keeps the generators of a start inside the regions.
void keep_inside(const CheckedMesh& input, PartedMesh& parted, RelaxationStartOptions& options, Observer& observer) {
  const StartOptions& constraints = options.constraints;
  const bool leaves_out = std::ranges::any_of(parted.regions, [](std::int32_t region) { return region < 0; });
  if (leaves_out && (constraints.crease_angle || constraints.keep_boundary)) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("\1{}\2 would put generators into the faces that are left out; leave it out",
                            constraints.crease_angle ? "features" : "keep_boundary"));
  }
  move_into_regions(input.mesh, parted.regions, options.listed);
  move_into_regions(input.mesh, parted.regions, options.constraints.fixed);
  options.sample = [&](const SamplingOptions& sampling) { return sample_inside(parted, sampling, false, observer); };
}

RelaxationStart start(const CheckedMesh& input, LloydCall& call, ResolvedGenerators& listed, PartedMesh& parted,
                      Observer& observer) {
  call.start.copy = copy_options(call.relaxation, call.start.copy);
  RelaxationStartOptions options =
      make_start_options(input, call.generators, call.diagram, call.constraints, call.start, listed, observer);
  if (parted.is_parted()) {
    keep_inside(input, parted, options, observer);
    listed.points = options.listed;
  }
  RelaxationStart made;
  {
    Step step(observer, "generators");
    options.on_step = [&step](std::string_view name) { step.next(name); };
    made = start_relaxation(parted.surface(input.mesh), options);
  }
  tell_start(observer, input.mesh, made, options, call.generators.are_listed());
  return made;
}

LloydResult relax(const Mesh& mesh, const RelaxationStart& start, const LloydCall& call, Observer& observer) {
  LloydOptions options = call.relaxation;
  options.diagram = call.diagram;
  options.progress = progress_of(observer);
  options.on_iteration = [&](std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators) {
    if (call.relaxation.on_iteration) call.relaxation.on_iteration(iterations, energy, generators);
    observer.iterated(iterations, energy, generators);
    show_iteration(observer, iterations, energy);
  };
  LloydResult result = as_step(observer, kRelaxationStep, [&] { return relax_generators(mesh, start, options); });
  observer.status("");
  tell_copy(observer, result.copy, start, false);
  observer.note(fmt::format("{}, energy {:.6g} -> {:.6g} mesh units^4: {}",
                            counted(std::ssize(result.iterations), "iteration", "iterations"), result.initial_energy,
                            result.final_energy, describe(result.stop)));
  observer.note(
      fmt::format("areas of the cells: coefficient of variation {:.3g}", area_variation(result.diagram.cells)));
  return result;
}

/// Balances the cells of a relaxation, and updates the relaxation's result. The density of the input's faces also
/// serves for the surface, which has the same faces.
BalancedRelaxation balance(const CheckedMesh& input, const Mesh& surface, const RelaxationStart& start,
                           const LloydCall& call, LloydResult& relaxed, Observer& observer) {
  BalancedRelaxationOptions options;
  options.balance.density = find_density(input, call.balance);
  options.balance.diagram = call.diagram;
  options.balance.diagram.progress = progress_of(observer);
  options.density = start.density;
  options.freedom = start.freedom;
  options.creases = start.creases;
  BalancedRelaxation found =
      as_step(observer, "balance", [&] { return relax_balanced(surface, relaxed.generators, options); });
  relaxed.generators = found.balanced.diagram.generators;
  relaxed.moments = std::move(found.moments);
  relaxed.final_energy = 0;
  for (const CellMoments& cell : relaxed.moments) relaxed.final_energy += cell.energy;
  relaxed.residual = found.residual;
  relaxed.mean_cell_radius = found.mean_cell_radius;
  observer.note(fmt::format("{} of balancing, generators at most {:.2g} mean cell radii from their centroids",
                            counted(found.rounds, "round", "rounds"), found.residual / found.mean_cell_radius));
  tell_balance(observer, found.balanced);
  relaxed.diagram = std::exchange(found.balanced.diagram, {});
  return found;
}

/// Adds a list for each figure of the iterations. The first energy is the energy of the initial generators.
void add_iterations(const Figures& figure, const LloydResult& result) {
  const std::vector<LloydIteration>& done = result.iterations;
  std::vector<double> energies = each_of(done, &LloydIteration::energy);
  if (!result.generators.empty()) energies.insert(energies.begin(), result.initial_energy);
  figure("energies", "mesh units to the fourth", "at the start and after each iteration", energies);
  figure("steps", "", "how each step was found", each_of(done, step_name));
  figure("relocated_generators", "", "that left their places for distant ones",
         each_of(done, &LloydIteration::relocated));
  figure("methods", "", "of the diagram that each energy was measured with", each_of(done, measure_name));
  figure("largest_moves", "mesh units", "longest path of a generator", each_of(done, &LloydIteration::largest_move));
  figure("mean_moves", "mesh units", "mean length of the paths", each_of(done, &LloydIteration::mean_move));
  figure("step_scales", "", "factor of all steps", each_of(done, &LloydIteration::scale));
  figure("held_generators", "", "that did not move: they would collide", each_of(done, &LloydIteration::held));
}

}  // namespace

std::string_view measure_name(const LloydIteration& iteration) {
  return iteration.is_sampled ? "sampled" : name_in(kMethodNames, iteration.method);
}

std::string_view step_name(const LloydIteration& iteration) {
  if (iteration.relocated > 0) return "relocation";
  return iteration.by == Acceleration::none ? "lloyd" : name_in(kAccelerationNames, iteration.by);
}

void describe(OptionList& list, LloydCall& call) {
  describe(list, call.generators);
  describe(list, call.diagram);
  describe(list, call.relaxation);
  describe(list, call.constraints);
  describe(list, call.start);
  list.group("Relaxation");
  describe_balance(list, call.balance, "In the end, make all cells equal and keep the generators near their centroids",
                   call.diagram);
  list.group("Constraints");
  describe(list, call.regions, "cells and distances");
  list.excludes("coarse", {"within", "mask"}, "there is no copy of regions");
}

void LloydOutcome::visit(ObjectVisitor& visitor) const {
  const LloydResult& result = *relaxed;
  const std::vector<CellMoments>& moments = result.moments.raw();
  const Figures figure(visitor);
  figure("iterations", "", "number of iterations", result.iterations.size());
  figure("stop", "", "why the relaxation ended", name_in(kLloydStopNames, result.stop));
  add_iterations(figure, result);
  visit_copy(visitor, result.copy);
  figure("residual", "mesh units", "largest distance from a generator to its centroid", result.residual);
  figure("mean_cell_radius", "mesh units", "sqrt(area / (pi cells))", result.mean_cell_radius);
  figure("diagrams", "", "that were computed", result.diagrams);
  figure("area_variation", "", "standard deviation of the cells' areas by their mean",
         area_variation(result.diagram.cells));
  figure("final_energy", "mesh units to the fourth", "of the diagram", result.final_energy);
  visit_parted(visitor, diagram->parted());
  visit_balance(visitor, balanced ? std::optional(balanced->balanced) : std::nullopt);
  figure("balance.rounds", "", "moves of all generators", balanced ? Figure(plain(balanced->rounds)) : Figure());
  figure("weights", "mesh units", "of the generators, by which the cells are equal",
         balanced ? Figure(result.diagram.weights) : Figure());
  visitor.points({"generators", "", "relaxed ones"}, result.generators);
  visitor.array({"areas", "square mesh units", "of the cells"}, view(moments, &CellMoments::area));
  visitor.array({"cell_energies", "mesh units to the fourth", "of the cells"}, view(moments, &CellMoments::energy));
  visitor.part({"diagram", "", "of the generators"}, "diagram", [this] { return diagram; });
}

OwnWriters LloydOutcome::part_writers(std::string_view part) const {
  OwnWriters writers;
  if (part != "points") return writers;
  for (const auto& [name, known] : kPointFormatNames) {
    const PointFormat format = known;  // clang 14 can't capture structured bindings
    writers[std::string(name)] = [this, format](std::ostream& out) {
      std::vector<SurfaceSample> samples;
      for (const GeneratorId g : relaxed->moments.ids()) {
        const CellMoments& moments = relaxed->moments[g];
        samples.push_back({relaxed->generators[g.index()], moments.area, moments.energy});
      }
      write_points(out, diagram->mesh()->mesh, samples, format);
    };
  }
  return writers;
}

std::shared_ptr<const LloydOutcome> run(const MeshPtr& input, LloydCall& call, Observer& observer) {
  call.diagram.threads = observer.threads;
  auto outcome = std::make_shared<LloydOutcome>();
  const auto parted = std::make_shared<PartedMesh>(find_parted(*input, call.regions, observer));
  separate(input->mesh, *parted, observer);
  const Mesh& surface = parted->surface(input->mesh);
  ResolvedGenerators listed;
  const RelaxationStart made = start(*input, call, listed, *parted, observer);
  LloydResult relaxed = relax(surface, made, call, observer);
  if (call.balance.is_given()) outcome->balanced = balance(*input, surface, made, call, relaxed, observer);
  tell_diagram(observer, relaxed.diagram);
  outcome->snap_distance = snaps_of_unmoved(listed, relaxed.generators);
  outcome->relaxed = std::make_shared<const LloydResult>(std::move(relaxed));
  resolve(call.diagram);
  resolve(call.relaxation);
  const std::shared_ptr<const Diagram> whole(outcome->relaxed, &outcome->relaxed->diagram);
  outcome->diagram = std::make_shared<DiagramObject>(input, whole, call.diagram, parted);
  return outcome;
}

}  // namespace gvd
