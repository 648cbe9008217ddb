// The operation `remesh`: chooses and relaxes generators, and builds the coarse mesh of their diagram.
//
// The library makes the mesh (gvd/remesh_surface.hpp). With `error`, a search first finds the fewest generators whose
// remesh is near enough, and the run follows with this number. The figures tell everything; the notes tell what users
// should not miss: generators that were added and why, creases that edges do not follow, intersections, and the
// distance from the input in percent of the diagonal.

#include "gvd/remesh_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "figures.hpp"
#include "gvd/carry_properties.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "gvd/quality.hpp"
#include "gvd/remesh_options.hpp"
#include "gvd/remesh_scenes.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_distance.hpp"
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

/// Adds rules for options that have no effect because no generator is relaxed or no vertex is fitted.
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

/// Makes the library's options, and replaces options such as `auto` in `call` by the values used.
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

/// Finds the fewest generators that keep the requested distance. Returns their number.
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

/// The number of generators for a mean edge length, from the area of a generator in an even triangulation.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("\1target_edge={}\2: this takes {:.3g} generators; ask for longer edges", edge, count));
}

/// Chooses generators and makes their remesh, with a step for each part of the work.
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

// ---- the parts of the result

void add_figures(const Figures& figure, const TriangleQuality& q) {
  figure("q_min", "", "least Q of a triangle: 1 for an equilateral one", q.q_min);
  figure("q_average", "", "mean Q", q.q_average);
  figure("angle_min", "degrees", "least angle", q.angle_min);
  figure("angle_min_average", "degrees", "mean of the triangles' least angles", q.angle_min_average);
  figure("percent_below_30", "percent", "of the triangles have an angle below 30 degrees", q.percent_below_30);
}

void add_figures(const Figures& figure, const Valences& v) {
  figure("least", "", "edges at a vertex", v.least);
  figure("largest", "", "edges at a vertex", v.largest);
  figure("percent_regular", "percent", "of the vertices have six edges, or four on the boundary", v.percent_regular);
}

void add_figures(const Figures& figure, const RemeshCertificate& c) {
  figure("manifold", "", "whether the remesh is", c.manifold);
  figure("closed_as_input", "", "whether it is closed where the input is", c.closed_as_input);
  figure("same_euler_characteristic", "", "as the input has", c.same_euler_characteristic);
  figure("same_components", "", "as the input has", c.same_components);
  figure("same_boundary_loops", "", "as the input has", c.same_boundary_loops);
  figure("same_in_each_component", "", "whether this holds for each component", c.same_in_each_component);
  figure("flipped_faces", "", "number of flipped triangles", c.flipped_faces);
  figure("unused_generators", "", "without a triangle", c.unused_generators);
  figure("self_intersections", "", "pairs of triangles that intersect", std::ssize(c.self_intersections));
  figure("inherited_intersections", "", "pairs that do so where the input does", c.inherited_intersections);
  figure("intersections_allowed", "", "whether others are accepted", c.intersections_allowed);
}

void add_figures(const Figures& figure, const SurfaceDistance& d) {
  figure("hausdorff", "mesh units", "largest distance that was measured", d.hausdorff);
  figure("hausdorff_bound", "mesh units", "no distance is larger", d.hausdorff_bound);
  figure("rms", "mesh units", "root mean square distance", d.rms);
}

/// The words for one and for several violations of each property, in the order of the properties.
constexpr std::array<std::pair<const char*, const char*>, 11> kDefectWords{{
    {"component of the mesh has no generator", "components of the mesh have no generator"},
    {"cell is not a disc", "cells are not discs"},
    {"cell touches the mesh's boundary in several arcs", "cells touch the mesh's boundary in several arcs"},
    {"bisector has no branch point", "bisectors have no branch point"},
    {"pair of cells shares several bisectors", "pairs of cells share several bisectors"},
    {"set of cells shares several branch points", "sets of cells share several branch points"},
    {"cell has too few neighbours", "cells have too few neighbours"},
    {"branch point touches a cell twice", "branch points touch a cell twice"},
    {"branch point can't be cut into triangles", "branch points can't be cut into triangles"},
    {"triangle is flipped or has an edge of length 0", "triangles are flipped or have an edge of length 0"},
    {"triangle intersects another one", "triangles intersect others"},
}};

/// Describes the defects, with a part for each property: "3 cells are not discs, 1 triangle is flipped ..."
std::string describe_defects(const std::vector<DualDefect>& defects) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < kDefectWords.size(); ++i) {
    const auto has_property = [i](const DualDefect& d) { return static_cast<std::size_t>(d.property) == i + 1; };
    const auto count = std::count_if(defects.begin(), defects.end(), has_property);
    const auto& [one, several] = kDefectWords[i];
    if (count > 0) parts.push_back(counted(count, one, several));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Advice on how the edges could follow more of the creases.
const char* following_advice(const RemeshResult& result, const RemeshOptions& options) {
  if (!options.refine || options.vertex_count)
    return "without \1refine=false\2 and \1exact_count\2, generators are added there";
  if (result.creases_lack_added) return "raise \1max_added\2";
  return "give more generators";
}

std::int64_t count_given(const RemeshResult& result) {
  const DecimatedParts& decimated = result.decimated;
  return std::ssize(result.generators) - result.added + result.left_out - decimated.vertices + decimated.generators;
}

/// Why one component was decimated, and why several were.
constexpr std::array<std::pair<const char*, const char*>, 5> kCauseWords{{
    {"gets more defects from round to round", "get more defects from round to round"},
    {"takes too long to repair", "take too long to repair"},
    {"would take too many generators", "would take too many generators"},
    {"has a tip too narrow for generators", "have a tip too narrow for generators"},
    {"has no room for more generators", "have no room for more generators"},
}};

/// "3 would take too many generators, 1 has no room for more generators"; without numbers where all parts are alike.
std::string describe_causes(const DecimatedParts& decimated) {
  std::vector<std::string> parts;
  for (const auto& [cause, count] : decimated.causes) {
    const auto& [one, several] = kCauseWords[static_cast<std::size_t>(cause)];
    const char* const words = count == 1 ? one : several;
    parts.push_back(decimated.components == 1 ? fmt::format("it {}", words) : fmt::format("{} {}", count, words));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Describes the components that were decimated and are not dual to generators.
void describe_decimated(const RemeshResult& result, std::vector<std::string>& lines) {
  const DecimatedParts& decimated = result.decimated;
  if (decimated.components == 0) return;
  const std::int64_t all = result.certificate.input.components;
  lines.push_back(fmt::format(
      "{} the input's own triangles, decimated to {} in place of {}, since the dual of generators there "
      "is no valid mesh: {}; the first defect: {}",
      all == 1 ? "the surface is"
               : fmt::format("{} of {} connected parts {}", decimated.components, all,
                             decimated.components == 1 ? "is" : "are"),
      counted(decimated.vertices, "vertex", "vertices"), counted(decimated.generators, "generator", "generators"),
      describe_causes(decimated), decimated.reason));
}

/// Describes the generators that were added, and why.
void describe_added(const RemeshResult& result, std::vector<std::string>& lines) {
  if (result.added_on_creases > 0) {
    lines.push_back(fmt::format("{} added on creases and boundaries{}",
                                counted(result.added_on_creases, "generator was", "generators were"),
                                result.crease_gap_length > 0 ? "" : ", which the edges then follow"));
  }
  const std::int64_t repairs = result.added - result.added_on_creases;
  if (repairs <= 0) return;
  const std::string added = counted(repairs, "generator was", "generators were");
  lines.push_back(result.given_defects.empty()
                      ? fmt::format("{} added to repair the mesh", added)
                      : fmt::format("{} added: with the given {}, {}", added, count_given(result),
                                    describe_defects(result.given_defects)));
}

void describe_searches(const RemeshResult& result, std::vector<std::string>& lines) {
  if (result.left_out > 0) {
    lines.push_back(counted(result.left_out, "generator was", "generators were") +
                    " left out for them, where the mesh can do without");
  }
  if (result.search_cut_short) {
    lines.push_back(
        "the search for fewer vertices ended at its limit, a third of the run's other diagrams; fewer may do");
  }
}

/// Describes how many triangles are nearly flat lines, and where the worst one is.
void describe_slivers(const RemeshResult& result, std::vector<std::string>& lines) {
  if (result.slivers.empty()) return;
  const auto corner = [&](FaceId f, int i) { return result.mesh.position(result.mesh.vertices(f)[i]); };
  const auto q = [&](FaceId f) { return compute_q(corner(f, 0), corner(f, 1), corner(f, 2)); };
  const FaceId worst =
      *std::min_element(result.slivers.begin(), result.slivers.end(), [&](FaceId f, FaceId g) { return q(f) < q(g); });
  const Vec3 at = (corner(worst, 0) + corner(worst, 1) + corner(worst, 2)) / 3;
  lines.push_back(fmt::format("{} a Q below {}; the least is {:.3g}, near ({:.6g}, {:.6g}, {:.6g})",
                              counted(std::ssize(result.slivers), "triangle has", "triangles have"), kSliverQ, q(worst),
                              at.x(), at.y(), at.z()));
}

void describe_intersections(const RemeshCertificate& certificate, std::vector<std::string>& lines) {
  const std::int64_t inherited = certificate.inherited_intersections;
  const std::int64_t own = std::ssize(certificate.self_intersections) - inherited;
  if (own > 0) lines.push_back(counted(own, "pair of triangles intersects", "pairs of triangles intersect"));
  if (inherited > 0) {
    lines.push_back(counted(inherited, "pair of triangles intersects where the input does",
                            "pairs of triangles intersect where the input does"));
  }
}

/// A remesh is far from its input if its Hausdorff distance exceeds this many spacings of its vertices. In an even
/// triangulation no point is farther than 1 / sqrt(3) of a spacing from a vertex, so beyond a whole spacing a part of
/// the input has no vertices.
constexpr double kFarSpacings = 1;

/// The larger of the two Hausdorff distances, and the spacing of as many evenly distributed vertices; mesh units.
struct Nearness {
  double hausdorff;
  double spacing;
  bool is_far() const { return hausdorff > kFarSpacings * spacing; }
};

Nearness nearness_of(const RemeshResult& result) {
  return {std::max(result.input_to_output.hausdorff, result.output_to_input.hausdorff),
          even_spacing(result.certificate.input.area, result.mesh.vertex_count())};
}

/// The least number of three digits that is not below x: what "at most" says in print.
double round_up(double x) {
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return std::ceil(x / unit) * unit;
}

void describe_distance(const RemeshResult& result, std::vector<std::string>& lines) {
  const double diagonal = result.certificate.input.bbox_diagonal;
  if (!(diagonal > 0)) return;
  const SurfaceDistance &there = result.input_to_output, &back = result.output_to_input;
  if (const Nearness nearness = nearness_of(result); nearness.is_far()) {
    std::string advice = "give more generators";
    if (result.crease_length > 0) advice += ", or compare \1features=none\2";
    if (result.crease_length > 0 && result.certificate.input.boundary_loops > 0) advice += " and \1loose_boundary\2";
    lines.push_back(
        fmt::format("part of the input has too few vertices: its distance is {:.3g} times that between "
                    "vertices, where at most {} is usual; {}",
                    nearness.hausdorff / nearness.spacing, kFarSpacings, advice));
  }
  const double found = std::max(there.hausdorff, back.hausdorff);
  const double bound = std::max(there.hausdorff_bound, back.hausdorff_bound);
  const double least_tolerance = kLeastHausdorffTolerance * std::max(diagonal, result.mesh.bbox_diagonal());
  const double close = found + std::max(kHausdorffTolerance * found, least_tolerance);
  lines.push_back(fmt::format(
      "distance from the input, in % of the diagonal: {:.3g} at most{}, {:.3g} RMS", round_up(100 * bound / diagonal),
      bound <= close
          ? ""
          : fmt::format(" ({:.3g} found; the search for the largest ended at its limit)", 100 * found / diagonal),
      100 * std::max(there.rms, back.rms) / diagonal));
}

void add_relaxation(ObjectVisitor& visitor, const SurfaceRemesh& made) {
  const Figures figure(visitor, "relaxation", made.relaxation.has_value());
  const LloydResult& relaxed = or_none(made.relaxation);
  figure("iterations", "", "that moved the generators", std::ssize(relaxed.iterations));
  figure("stop", "", "why they ended", name_in(kLloydStopNames, relaxed.stop));
  figure("initial_energy", "mesh units to the fourth", "before them", relaxed.initial_energy);
  figure("final_energy", "mesh units to the fourth", "after them", relaxed.final_energy);
  figure("extremities", "", "generators that went to ends of limbs", std::ssize(relaxed.extremities));
  figure("diagrams", "", "that were computed", relaxed.diagrams);
  visit_copy(visitor, relaxed.copy, "relaxation.coarse");
}

void add_map(const Figures& figure, const RemeshMap& map) {
  figure("one_to_one", "", "whether the map is", map.one_to_one);
  figure("obstacle", "", "what is in the way", map.one_to_one ? Figure() : Figure(map.obstacle));
  figure("kept_faces", "", "of the input, whose image is oriented as the remesh", map.kept_faces);
  figure("reversed_faces", "", "whose image is turned round", map.reversed_faces);
  figure("collapsed_faces", "", "whose image has no area", map.collapsed_faces);
  figure("largest_move", "mesh units", "from a vertex to its point", map.largest_move);
  figure("mean_move", "mesh units", "mean of these", map.mean_move);
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
  outcome->carries = call.carry;
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

void RemeshOutcome::visit(ObjectVisitor& visitor) const {
  const auto group = [&](const char* name) { return Figures(visitor, name); };
  const Figures figure(visitor), creases = group("creases"), distance = group("distance");
  const RemeshResult& result = made->result;
  add_relaxation(visitor, *made);
  figure("added_generators", "", "beside the given ones", result.added);
  figure("left_out_generators", "", "of the given ones", result.left_out);
  figure("rounds", "", "diagrams, before a search for fewer generators", result.rounds);
  figure("search_cut_short", "", "whether fewer generators may do", result.search_cut_short);
  figure("decimated_components", "", "whose own triangles, decimated, stand for a dual", result.decimated.components);
  figure("decimated_vertices", "", "in these, each at a vertex of the input", result.decimated.vertices);
  figure("decimated_generators", "", "given ones, whose place these vertices took", result.decimated.generators);
  figure("slivers", "", "triangles that are nearly flat lines", std::ssize(result.slivers));
  creases("length", "mesh units", "of creases and boundary to follow", result.crease_length);
  creases("followed", "mesh units", "that edges follow", result.crease_length - result.crease_gap_length);
  creases("added_generators", "", "on them", result.added_on_creases);
  visit_summary(visitor, result.certificate.output, "output");
  const Figures certificate = group("certificate");
  add_figures(certificate, result.certificate);
  certificate("dropped_components", "", "of the input, left out before",
              input->defects.count(DefectKind::dropped_components));
  add_figures(group("quality.input"), result.input_quality);
  add_figures(group("quality.output"), result.output_quality);
  add_figures(group("valences.input"), compute_valences(input->mesh));
  add_figures(group("valences.output"), compute_valences(result.mesh));
  add_figures(group("distance.input_to_output"), result.input_to_output);
  add_figures(group("distance.output_to_input"), result.output_to_input);
  const Nearness nearness = nearness_of(result);
  distance("vertex_spacing", "mesh units", "of as many even vertices", nearness.spacing);
  distance("is_far", "", "whether a part of the input has too few vertices", nearness.is_far());
  figure("search.hausdorff", "mesh units", "the distance that was asked for",
         search ? Figure(search_distance) : Figure());
  const std::vector<CountTrial>& trials = or_none(search).trials;
  visitor.table({"search.trials", "", "numbers of generators that were tried"},
                {{"n", each_of(trials, &CountTrial::count)}, {"hausdorff", each_of(trials, &CountTrial::error)}});
  add_map(Figures(visitor, "map", map.has_value()), or_none(map));

  visitor.points({"generators", "", "of each vertex of the remesh, on the input"}, result.generators);
  visitor.points({"face_points", "", "the branch point of each face, on the input"}, result.face_points);
  visitor.points({"map_points", "", "of each vertex of the input, on the remesh; empty without map"},
                 or_none(map).points.raw());
  visitor.points({"map_origins", "", "of each vertex of the remesh, on the input; empty without map"},
                 or_none(map).origins.raw());
  visitor.part({"mesh", "", "the coarse mesh"}, "mesh", [this]() -> std::shared_ptr<const Object> {
    auto coarse = std::make_shared<CheckedMesh>(as_input(made->result.mesh));
    coarse->appearance = appearance;
    return std::make_shared<MeshObject>(std::move(coarse));
  });
  visitor.part({"diagram", "", "of all generators"}, "diagram", [this] {
    return std::make_shared<DiagramObject>(input, std::shared_ptr<const Diagram>(made, &made->result.diagram), options);
  });
}

std::optional<LabelledMesh> RemeshOutcome::labelled() const {
  LabelledMesh coarse{made->result.mesh};
  coarse.properties = &properties;
  coarse.appearance = &appearance;
  return coarse;
}

void RemeshOutcome::check_file(const WrittenFile& file) const {
  if (!carries || has_any(file.format->carries, kCarried)) return;
  throw Error(
      ErrorCode::invalid_option,
      fmt::format("\1carry\2: {} what is carried over; write one or leave \1carry\2 out", only_formats(kCarried)));
}

OwnWriters RemeshOutcome::own_writers() const {
  return {{"json", [this](std::ostream& out) { write_remesh_json(out, input->mesh, made->result); }}};
}

OwnWriters RemeshOutcome::part_writers(std::string_view part) const {
  if (part != "map" || !map) return {};
  return {{"json", [this](std::ostream& out) { write_map_json(out, *input, *map); }}};
}

std::string RemeshOutcome::page(const FileOptions& how) const {
  ViewOptions view;
  view.title = how.title;
  const Mesh unplaced = make_unplaced(input->mesh, made->result);
  return make_view_page(make_remesh_scenes(input->mesh, made->result, unplaced, how.threads), view);
}

std::shared_ptr<const RemeshOutcome> run(const RemeshOutcome& on, MapCall&, Observer& observer) {
  auto mapped = std::make_shared<RemeshOutcome>(on);
  mapped->map = as_step(observer, "map", [&] {
    return map_to_remesh(on.input->mesh, on.made->result, observer.threads, progress_of(observer));
  });
  return mapped;
}

std::vector<std::string> describe_remesh(const RemeshResult& result, const RemeshOptions& options) {
  std::vector<std::string> lines{fmt::format("{}, {}: manifold, with the input's topology",
                                             counted(result.mesh.vertex_count(), "vertex", "vertices"),
                                             counted(result.mesh.face_count(), "face", "faces"))};
  describe_added(result, lines);
  describe_decimated(result, lines);
  if (result.crease_gap_length > 0) {
    lines.push_back(fmt::format("creases and boundaries: edges do not follow {:.3g} % of their length; {}",
                                100 * result.crease_gap_length / result.crease_length,
                                following_advice(result, options)));
  }
  describe_searches(result, lines);
  describe_intersections(result.certificate, lines);
  describe_slivers(result, lines);
  describe_distance(result, lines);
  return lines;
}

}  // namespace gvd
