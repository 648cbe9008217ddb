// The operation `remesh`: generators, their relaxation, and the coarse mesh of their diagram.
//
// The library makes the mesh (gvd/remesh_surface.hpp). With `error`, the fewest generators whose remesh is near enough
// are searched for first, and the run follows with their number.

#include "gvd/remesh_operation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "gvd/carry_properties.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh_options.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

void describe_sizes(OptionList& list, GeneratorOptions& generators) {
  list.group("Sizes (in place of \1count\2, \1generators\2, \1vertices\2 and \1radius\2)");
  list.option("target_edge", Number{&generators.target_edge, above(0)},
              {.help = "Sample as many generators as give edges of this average length",
               .unit = "mesh units",
               .shown = Shown::main});
  list.option("error", SizeOrPercent{&generators.error},
              {.help = "Use the fewest generators whose mesh stays within this distance of the input",
               .more = ", in mesh units or in percent of the bounding box's diagonal; takes up to 17 remeshes",
               .shown = Shown::main});
  for (const char* size : {"target_edge", "error"}) list.excludes(size, {"merge_coincident"});
}

/// The options that do nothing because no generator is relaxed, or no vertex fitted.
void describe_rules(OptionList& list, const RemeshCall& call) {
  const auto is_listed = [&call] { return call.generators.are_listed(); };
  for (const char* name : {"density", "fixed", "coarse"}) {
    list.rule({name, {"relax", "generators", "vertices"}, [&call, is_listed, name](const Given& given) -> std::string {
                 const bool off = std::string_view(name) == "coarse" && call.remesh.start.copy.faces.value_or(0) == 0;
                 if (off || call.remesh.relaxation.value_or(is_listed() ? 0 : kRemeshRelaxation) > 0) return "";
                 return fmt::format(
                     "\1{}\2: no generator is moved; {}", name,
                     given.has("relax") ? "leave it out, or leave out \1relax=none\2" : "ask for it with \1relax=N\2");
               }});
  }
  list.rule({"shape", {"place", "generators", "vertices"}, [&call, is_listed](const Given& given) -> std::string {
               const Placement usual = is_listed() ? Placement::generator : Placement::fit;
               if (call.remesh.placement.value_or(usual) == Placement::fit) return "";
               return fmt::format("\1shape\2: no vertex is fitted; {}", given.has("place")
                                                                            ? "leave it out, or take \1place=fit\2"
                                                                            : "ask for it with \1place=fit\2");
             }});
}

/// The library's options; the user's own ones become what they stand for.
SurfaceRemeshOptions make_options(const CheckedMesh& input, RemeshCall& call, ResolvedGenerators& listed,
                                  Observer& observer) {
  SurfaceRemeshOptions options = call.remesh;
  options.start =
      make_start_options(input, call.generators, call.diagram, call.constraints, call.remesh.start, listed, observer);
  options.remesh.diagram = call.diagram;
  options.remesh.diagram.progress = progress_of(observer);
  call.remesh.relaxation = options.iterations();
  call.remesh.placement = options.chosen_placement();
  StartOptions& constraints = call.remesh.start.constraints;
  if (constraints.prefers_creases && !options.may_add()) {
    constraints.prefers_creases = false;
    constraints.crease_angle.reset();
  }
  return options;
}

/// Searches for the fewest generators that keep the distance that was asked for. Returns their number.
std::int32_t search_count(const Mesh& mesh, const ErrorBound& bound, const SurfaceRemeshOptions& options,
                          Observer& observer, RemeshOutcome& outcome) {
  outcome.search_distance = bound.value * (bound.in_diagonals ? mesh.bbox_diagonal() : 1);
  const auto show = [&observer](const CountTrial& trial) {
    observer.status(fmt::format("{} generators tried", trial.count));
    observer.detail(std::isfinite(trial.error)
                        ? fmt::format("{} generators: distance {:.6g} mesh units", trial.count, trial.error)
                        : fmt::format("{} generators: no mesh", trial.count));
  };
  outcome.search =
      as_step(observer, "trials", [&] { return find_remesh_count(mesh, options, outcome.search_distance, show); });
  observer.status("");
  return *outcome.search->count;
}

/// The number of generators for a mean length of edges: by the area that each one has in an even triangulation.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("\1target_edge={}\2: this takes {:.3g} generators; ask for longer edges", edge, count));
}

/// Generators and their remesh, with the time of every step.
SurfaceRemesh make_remesh(const Mesh& mesh, SurfaceRemeshOptions options, Observer& observer) {
  Step step(observer, "generators");
  options.on_step = [&](std::string_view name) {
    step.next(name);
    observer.status("");
  };
  options.on_iteration = [&](std::int64_t iterations, double energy) { show_iteration(observer, iterations, energy); };
  return remesh_surface(mesh, options);
}

void tell(Observer& observer, const Mesh& mesh, const RemeshCall& call, const SurfaceRemesh& made) {
  tell_start(observer, mesh, made.start, call.remesh.start, call.generators.are_listed());
  if (made.relaxation) {
    const LloydResult& relaxed = *made.relaxation;
    tell_copy(observer, relaxed.copy, made.start, made.relaxation_ends_on_copy);
    observer.detail(fmt::format("generators relaxed in {}, energy {:.6g} -> {:.6g} mesh units^4",
                                counted(std::ssize(relaxed.iterations), "iteration", "iterations"),
                                relaxed.initial_energy, relaxed.final_energy));
  }
  for (const std::string& line : describe_remesh(made.result, made.options)) observer.note(line);
}

void tell_map(Observer& observer, const RemeshMap& map) {
  const std::string move = fmt::format("vertices are {:.3g} from their points on average", map.mean_move);
  observer.note(map.one_to_one ? "map: one-to-one; " + move
                               : fmt::format("map: nearest points, several vertices may have the same one: {}; {}",
                                             map.obstacle, move));
}

}  // namespace

void describe(OptionList& list, RemeshCall& call) {
  describe(list, call.generators, {"target_edge", "error"});
  describe(list, call.diagram);
  describe_sizes(list, call.generators);
  list.group("Relaxation");
  describe(list, call.constraints);
  describe(list, call.remesh);
  describe_rules(list, call);
}

void describe_for_programs(OptionList& list, RemeshCall& call) {
  list.option("map", Flag{&call.map}, {.help = "Map the vertices of the input to the remesh, and back"});
  list.option("carry", Flag{&call.carry}, {.help = "Carry over texture coordinates and materials"});
}

std::shared_ptr<const RemeshOutcome> run(const MeshPtr& input, RemeshCall& call, Observer& observer) {
  const Mesh& mesh = input->mesh;
  call.diagram.threads = observer.threads;
  auto outcome = std::make_shared<RemeshOutcome>();
  outcome->input = input;
  ResolvedGenerators listed;
  SurfaceRemeshOptions options = make_options(*input, call, listed, observer);
  const GeneratorOptions& asked = call.generators;
  if (asked.error) options.start.sampling.count = search_count(mesh, *asked.error, options, observer, *outcome);
  if (asked.target_edge) options.start.sampling.count = count_for(mesh, *asked.target_edge);
  auto made = std::make_shared<SurfaceRemesh>(make_remesh(mesh, std::move(options), observer));
  tell(observer, mesh, call, *made);
  const RemeshResult& result = made->result;
  outcome->snap_distance = snaps_of_unmoved(listed, result.generators);
  call.remesh.remesh.max_added = result.max_added;
  outcome->made = std::move(made);
  if (call.map || call.carry) {
    outcome->map =
        as_step(observer, "map", [&] { return map_to_remesh(mesh, result, observer.threads, progress_of(observer)); });
  }
  if (call.carry) {
    const Step step(observer, "carry");
    outcome->properties = carry_properties(*input, call.properties, result, *outcome->map);
    outcome->appearance = carry_appearance(*input, result, *outcome->map);
  }
  if (call.map) {
    tell_map(observer, *outcome->map);
  } else {
    outcome->map.reset();
  }
  resolve(call.diagram);
  outcome->options = call.diagram;
  return outcome;
}

}  // namespace gvd
