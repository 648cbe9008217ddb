// Describes the options for generators, resolves lists to points of the surface, and samples generators.
//
// Listed generators are only moved to the surface. Sampling is seeded, so that the same options give the same points.

#include "gvd/generator_options.hpp"

#include <fmt/format.h>

#include <utility>

#include "gvd/constrained_start.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// A snap distance above this fraction of the bounding box's diagonal is noted, because the list may belong to another
/// model or have other units. Digitised and rounded points are much nearer to their surface.
constexpr double kFarSnap = 0.01;

void note_changes(Observer& observer, const GeneratorOptions& asked, const ResolvedGenerators& resolved,
                  double diagonal) {
  if (!asked.max_snap) note_far_entry(observer, resolved, diagonal);
  if (resolved.longest_snap.value_or(0) > 0) {
    observer.note(
        fmt::format("{}: moved to the surface, by at most {:.4g}", asked.points_name, *resolved.longest_snap));
  }
  if (resolved.merged == 0) return;
  observer.note(fmt::format("{}: {}", asked.points_name,
                            counted(resolved.merged, "is merged with an earlier one", "are merged with earlier ones")));
}

/// Resolves listed curves, with the same notes and limits as for points.
std::vector<GeneratorCurve> resolve_curves(const CheckedMesh& input, const GeneratorOptions& asked,
                                           Observer& observer) {
  ResolvedGenerators snapped;
  const ResolveOptions options{
      .input_vertices = &input.mesh_vertex, .max_snap = asked.max_snap, .progress = progress_of(observer)};
  std::vector<GeneratorCurve> curves = gvd::resolve_curves(input.mesh, *asked.curves.list, options, snapped);
  if (!asked.max_snap) note_far_entry(observer, snapped, input.mesh.bbox_diagonal());
  if (snapped.longest_snap.value_or(0) > 0) {
    observer.note(fmt::format("points of curves: moved to the surface, by at most {:.4g}", *snapped.longest_snap));
  }
  return curves;
}

/// Finds the curves for a word such as "boundary". Refuses a mesh that has no such curve.
std::vector<GeneratorCurve> find_curves(const Mesh& mesh, const std::string& name) {
  if (name == "boundary") {
    auto curves = boundary_curves(mesh);
    if (!curves.empty()) return curves;
    throw Error(ErrorCode::precondition,
                "\1curves=boundary\2: the mesh is closed and has no boundary; use \1curves=creases\2, a file "
                "of curves, or points");
  }
  const double angle = parse_creases(name, kUsualCreaseAngle).value_or(kUsualCreaseAngle);
  auto curves = crease_curves(mesh, angle);
  if (!curves.empty()) return curves;
  throw Error(ErrorCode::precondition,
              fmt::format("\1curves={}\2: no two faces meet at more than {} degrees; ask for a smaller angle, or use "
                          "the boundary or points",
                          name, angle));
}

/// The length of a curve. Segments that lie on each other count twice.
double length_of(const Mesh& mesh, const GeneratorCurve& curve) {
  double length = 0;
  for (const auto& [a, b] : curve.segments) {
    length += (position(mesh, curve.points[a]) - position(mesh, curve.points[b])).norm();
  }
  return length;
}

}  // namespace

void describe(OptionList& list, GeneratorOptions& generators, const std::vector<std::string>& others) {
  list.group(kGeneratorGroup);
  list.option("count", Number{&generators.count, {.least = 1}},
              {.help = "Number of generators to sample", .short_name = "n", .shown = Shown::main});
  list.option("sampling", choice(generators.sampling, kSamplingNames),
              {.help = "How \1count\2 places generators, and \1radius\2 those of farthest and poisson"});
  list.option("seed", Number{&generators.seed}, {.help = "Seed of the random choices"});
  list.option("radius", Number{&generators.radius, above(0)},
              {.help = "Sample generators until no point of the surface is farther than this from the nearest one",
               .unit = "mesh units"});
  list.option(
      "generators", PointList{&generators.points, PointList::Named::file},
      {.help = fmt::format("File that lists the generators ({})", list_extensions(generator_extensions(), "or")),
       .more = ", or - for standard input",
       .arrays = "The generators, as points",
       .shown = Shown::main});
  list.option("vertices", PointList{&generators.vertices, PointList::Named::vertices},
              {.help = "Use these vertices of the input file, counted from 0, as in 3,17,99",
               .arrays = "The generators, as vertices"});
  list.option(
      "max_snap", Number{&generators.max_snap, {.least = 0}},
      {.help = "Refuse a point of \1generators\2 that is farther than this from the surface", .unit = "mesh units"});
  list.option("merge_coincident", Flag{&generators.merge_coincident},
              {.help = "Merge generators that coincide instead of refusing them"});
  OneOf sources{{"count", "generators", "vertices", "radius"}, "no generators"};
  sources.options.insert(sources.options.end(), others.begin(), others.end());
  list.one_of(std::move(sources));
  list.excludes("sampling", {"generators", "vertices"});
  list.rule({"sampling", {"radius"}, [&generators](const Given&) -> std::string {
               const bool is_even =
                   generators.sampling == Sampling::farthest || generators.sampling == Sampling::poisson;
               return !generators.radius || is_even ? ""
                                                    : "\1sampling\2: a radius gives farthest or poisson points; give "
                                                      "\1count\2, or leave \1sampling\2 out";
             }});
  list.excludes("seed", {"generators", "vertices"});
  list.excludes("max_snap", {"count", "radius", "vertices"});
  list.excludes("merge_coincident", {"count", "radius"});
}

void describe_curves(OptionList& list, GeneratorOptions& generators) {
  list.option(
      "curves", Curves{&generators.curves, kUsualCreaseAngle},
      {.help = "Use curves as generators",
       .more = fmt::format(": polylines of a file (.obj, .ply, .json or text), the boundary loops, or connected edges "
                           "whose faces differ by more than ANGLE degrees ({} by default)",
                           kUsualCreaseAngle),
       .arrays = fmt::format("Use curves as generators: polylines through points, the boundary loops ('boundary'), or "
                             "connected edges whose faces differ by more than ANGLE degrees ('creases:ANGLE'; "
                             "'creases': {})",
                             kUsualCreaseAngle)});
}

SamplingOptions make_sampling_options(const GeneratorOptions& asked, const DiagramOptions& diagram,
                                      Observer& observer) {
  SamplingOptions options;
  options.seed = asked.seed;
  options.front = diagram.chosen_front();
  options.progress = progress_of(observer);
  if (asked.wanted()) options.count = *asked.wanted();
  if (asked.radius) options.radius = *asked.radius;
  options.kind = asked.radius ? Sampling::covering_radius : asked.sampling;
  options.blue_noise = asked.sampling == Sampling::poisson;
  return options;
}

GeneratorList list_points(const GivenPoints& points, const std::string& name) {
  if (points.list) return *points.list;
  GeneratorList list{name, {}};
  if (!points.vertices) return list;
  for (const std::int64_t vertex : *points.vertices) {
    list.entries.push_back({GeneratorEntry::Kind::vertex, vertex, {}, 0});
  }
  return list;
}

void note_far_entry(Observer& observer, const ResolvedGenerators& resolved, double diagonal) {
  if (!(resolved.longest_snap.value_or(0) > kFarSnap * diagonal)) return;
  observer.warn(fmt::format("{} is {:.4g} from the surface, and the model's diagonal is {:.4g}: check its units",
                            resolved.farthest, *resolved.longest_snap, diagonal));
}

std::vector<GeneratorCurve> choose_curves(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer) {
  const Step step(observer, "generators");
  std::vector<GeneratorCurve> curves =
      asked.curves.list ? resolve_curves(input, asked, observer) : find_curves(input.mesh, asked.curves.name);
  double length = 0;
  for (const GeneratorCurve& curve : curves) length += length_of(input.mesh, curve);
  observer.detail(fmt::format("{} of length {:.6g}", counted(std::ssize(curves), "curve", "curves"), length));
  return curves;
}

ResolvedGenerators resolve_listed(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer,
                                  bool keep_coincident) {
  const GivenPoints& points = asked.vertices.is_given() ? asked.vertices : asked.points;
  ResolvedGenerators found = resolve_generators(input.mesh, list_points(points, asked.vertices_name),
                                                {.input_vertices = &input.mesh_vertex,
                                                 .max_snap = asked.max_snap,
                                                 .merge_coincident = asked.merge_coincident && !keep_coincident,
                                                 .keep_coincident = keep_coincident,
                                                 .progress = progress_of(observer)});
  note_changes(observer, asked, found, input.mesh.bbox_diagonal());
  return found;
}

ResolvedGenerators choose_generators(const CheckedMesh& input, const GeneratorOptions& asked,
                                     const DiagramOptions& diagram, Observer& observer) {
  ResolvedGenerators found;
  const Step step(observer, "generators");
  if (asked.are_listed()) {
    found = resolve_listed(input, asked, observer);
  } else {
    found.points = sample_generators(input.mesh, make_sampling_options(asked, diagram, observer));
    found.snap_distance.resize(found.points.size());
    found.vertex.assign(found.points.size(), -1);
  }
  observer.detail(counted(std::ssize(found.points), "generator", "generators"));
  return found;
}

}  // namespace gvd
