// What gvd-lloyd and gvd-remesh share of a relaxation: its start by the options, and its words in reports and notes.
//
// The library places generators and weighs the surface (gvd/constrained_start.hpp, gvd/density.hpp). Here are the files
// that options name, and the messages that name options.

#include "common/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

std::vector<SurfacePoint> read_fixed(Run& run, const CheckedMesh& input, const std::string& file) {
  if (file.empty()) return {};
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  ResolvedGenerators fixed = resolve_generators(input.mesh, read_generators(file), options);
  note_far_entry(run, fixed, input.mesh.bbox_diagonal());
  return std::move(fixed.points);
}

Density choose_density(Run& run, const CheckedMesh& input, const ConstraintOptions& constraints, std::int64_t count) {
  const std::string& name = constraints.density;
  if (name.empty()) return {};
  if (name == "curvature") {
    return make_curvature_density(input.mesh, count, {.gradation = constraints.gradation, .progress = run.progress()});
  }
  const std::string& path = run.options().input.path;
  const bool piped = path == "-";
  if (auto density = read_density(input, name, piped ? "" : path)) return std::move(*density);
  throw Error(ErrorCode::unreadable_input,
              fmt::format("--density {}: there is no such file, and {} has no such property", name,
                          piped ? "standard input" : path));
}

StartOptions start_options(Run& run, const CheckedMesh& input, const ConstraintOptions& constraints) {
  StartOptions options;
  options.are_listed = run.options().generators.are_listed();
  options.fixed = read_fixed(run, input, constraints.fixed);
  options.crease_angle = constraints.features;
  options.prefers_creases = constraints.auto_features && !options.are_listed;
  if (options.prefers_creases) options.crease_angle = kUsualCreaseAngle;
  options.keep_boundary = constraints.keep_boundary;
  options.prefers_boundary = constraints.prefers_boundary;
  options.leaves_room = constraints.leaves_room;
  options.progress = run.progress();
  return options;
}

/// Notes which curves the generators do not keep to although that is preferred, and how many generators would do.
void note_unfollowed_curves(Run& run, const ConstrainedStart& start) {
  if (start.unfollowed_loops > 0) {
    run.console().note(
        fmt::format("boundary: {} of {} not followed, because this would take more than half of the generators; "
                    "-n {} puts some on each",
                    start.unfollowed_loops, counted(start.loops, "loop is", "loops are"), start.enough_for_loops));
  }
  if (start.leaves_creases) {
    const std::string enough =
        start.enough_for_creases > 0 ? fmt::format("-n {} or ", start.enough_for_creases) : std::string();
    run.console().note(
        fmt::format("creases: not followed, because this would take too many of the generators; {}--features {} "
                    "follows them",
                    enough, kUsualCreaseAngle));
  }
}

/// Least number of a copy's faces for each generator: with fewer, generators coincide.
constexpr std::int64_t kFacesPerGenerator = 2;

/// The copy to relax so many generators on first; nothing where the mesh is small, or less than twice as large.
std::optional<CoarseCopy> make_copy(Run& run, const Mesh& mesh, const ConstraintOptions& constraints,
                                    std::int64_t generators) {
  const bool is_large = mesh.face_count() > constraints.coarse_above;
  const std::int64_t by_default =
      is_large ? default_copy_faces(mesh.face_count(), generators, constraints.copy_size) : 0;
  const std::int64_t faces = constraints.coarse.value_or(by_default);
  if (faces == 0) return std::nullopt;
  if (faces < kFacesPerGenerator * generators) {
    run.console().note(fmt::format("--coarse {}: not used, because it has less than {} faces for a generator", faces,
                                   kFacesPerGenerator));
    return std::nullopt;
  }
  if (2 * faces > mesh.face_count()) {
    run.console().note(fmt::format("--coarse {}: not used, because the mesh has {} faces", faces, mesh.face_count()));
    return std::nullopt;
  }
  return run.timed("coarse copy",
                   [&] { return make_coarse_copy(mesh, faces, run.options().compute.threads, run.progress()); });
}

/// The generators of the run, or as many as `count`, and a copy to relax them on first. Where it is known how many
/// there will be, they are sampled on the copy.
std::pair<std::vector<SurfacePoint>, std::optional<CoarseCopy>> make_generators_and_copy(
    Run& run, const CheckedMesh& input, std::optional<std::int32_t> count, const ConstraintOptions& constraints) {
  if (!count) count = run.options().generators.count;
  std::optional<CoarseCopy> copy;
  if (count) copy = make_copy(run, input.mesh, constraints, *count);
  std::vector<SurfacePoint> points = make_generators(run, input, count, copy ? &*copy : nullptr);
  // A list may have relaxed generators: by default nothing moves them to a copy.
  if (!count && constraints.coarse) copy = make_copy(run, input.mesh, constraints, std::ssize(points));
  return {std::move(points), std::move(copy)};
}

}  // namespace

WeightedStart start_relaxation(Run& run, const CheckedMesh& input, std::optional<std::int32_t> count,
                               const ConstraintOptions& constraints) {
  auto [points, copy] = make_generators_and_copy(run, input, count, constraints);
  Density density = choose_density(run, input, constraints, std::ssize(points));
  const StartOptions options = start_options(run, input, constraints);
  WeightedStart start{constrain_start(input.mesh, std::move(points), options), std::move(density), std::move(copy)};
  note_unfollowed_curves(run, start);
  const auto count_of = [&](Freedom kind) { return std::count(start.freedom.begin(), start.freedom.end(), kind); };
  if (!start.freedom.empty()) {
    const char* const curves = options.crease_angle ? "creases or the boundary" : "the boundary";
    run.console().note(fmt::format("generators: {} fixed, {} on {}, {} free", count_of(Freedom::fixed),
                                   count_of(Freedom::on_crease), curves, count_of(Freedom::free)));
  }
  return start;
}

LloydResult run_relaxation(Run& run, const Mesh& mesh, const WeightedStart& start, LloydOptions options) {
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  options.copy = start.copy ? &*start.copy : nullptr;
  options.diagram = make_diagram_options(run.options().compute);
  if (!options.progress) options.progress = run.progress();
  options.on_iteration = [&run, also = std::move(options.on_iteration)](std::int64_t iterations, double energy,
                                                                        const std::vector<SurfacePoint>& generators) {
    if (also) also(iterations, energy, generators);
    run.console().set_status(fmt::format("iteration {}, energy {:.6g}", iterations, energy));
  };
  LloydResult result = run.timed("relaxation", [&] { return relax_generators(mesh, start.points, options); });
  run.console().set_status("");
  if (result.copy.faces > 0) {
    if (!options.ends_on_copy)
      run.console().note(fmt::format("relaxed in {} on a copy of {} faces first",
                                     counted(result.copy.iterations, "iteration", "iterations"), result.copy.faces));
  } else if (start.copy) {
    run.console().note(
        fmt::format("the copy of {} faces is not used, because it is too large or generators coincide on it",
                    start.copy->mesh.face_count()));
  }
  return result;
}

nlohmann::ordered_json describe_copy(const CoarseRelaxation& copy) {
  if (copy.faces == 0) return nullptr;
  return {{"faces", copy.faces}, {"iterations", copy.iterations}, {"diagrams", copy.diagrams}};
}

const char* name_of(LloydStop stop) {
  constexpr std::array<const char*, 6> kNames{"centroids",  "energy",     "no descent",
                                              "prediction", "iterations", "time limit"};
  return kNames[static_cast<std::size_t>(stop)];
}

void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints) {
  using Json = nlohmann::ordered_json;
  options["fixed"] = constraints.fixed.empty() ? Json() : Json(constraints.fixed);
  options["features"] = constraints.auto_features ? Json("auto")
                        : constraints.features    ? Json(*constraints.features)
                                                  : Json();
  options["keep_boundary"] = constraints.keep_boundary;
  options["density"] = constraints.density.empty() ? Json() : Json(constraints.density);
  options["gradation"] = constraints.gradation;
  options["coarse"] = constraints.coarse ? Json(*constraints.coarse) : Json();
}

}  // namespace gvd::app
