// What gvd-lloyd and gvd-remesh share of a relaxation: its start by the options, and its words in reports and notes.
//
// The library places generators and weighs the surface (gvd/constrained_start.hpp, gvd/density.hpp). Here are the files
// that options name, and the messages that name options.

#include "common/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

std::vector<SurfacePoint> read_fixed(Run& run, const CheckedMesh& input, const std::string& file) {
  if (file.empty()) return {};
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  const GeneratorList list = [&] {
    const WaitForInput wait(file);
    return read_generators(file);
  }();
  ResolvedGenerators fixed = resolve_generators(input.mesh, list, options);
  note_far_entry(run, fixed, input.mesh.bbox_diagonal());
  return std::move(fixed.points);
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

/// Notes why a copy that was asked for is not used.
void note_unused_copy(Run& run, const Mesh& mesh, std::int64_t faces, std::size_t generators) {
  const bool is_small = faces < kCopyFacesPerGenerator * std::int64_t(generators);
  run.console().note(
      is_small ? fmt::format("--coarse {}: not used, because it has less than {} faces for a generator", faces,
                             kCopyFacesPerGenerator)
               : fmt::format("--coarse {}: not used, because the mesh has {} faces", faces, mesh.face_count()));
}

}  // namespace

Density find_density(Run& run, const CheckedMesh& input, const std::string& option, const std::string& name) {
  return name.empty() ? Density() : find_numbers(run, input, option, name, read_density);
}

void describe(OptionList& list, ConstraintFiles& files) {
  list.group("Constraints");
  list.option("fixed", File{&files.fixed},
              {.help = "File that lists generators to keep in place", .more = "; {option:count} includes them"});
  list.option("density", ValueSource{&files.density, {"curvature"}},
              {.help = "Weight of the surface, above 0, which makes cells smaller where it is larger",
               .more = ": 'curvature', a file with a number for each vertex or each face (text, .npy, .shape.gii or "
                       "FreeSurfer's), or the name of a property of a PLY, VTP or VTU input"});
}

RelaxationStartOptions make_start_options(Run& run, const CheckedMesh& input, const ConstraintFiles& files,
                                          RelaxationStartOptions options) {
  if (run.options().generators.are_listed()) options.listed = make_generators(run, input);
  options.sampling = make_sampling_options(run);
  options.constraints.fixed = read_fixed(run, input, files.fixed);
  options.weighs_curvature = files.density == "curvature";
  if (!options.weighs_curvature) options.density = find_density(run, input, "--density", files.density);
  options.threads = run.options().compute.diagram.threads;
  options.progress = run.progress();
  return options;
}

void report_start(Run& run, const Mesh& mesh, const RelaxationStart& start, const RelaxationStartOptions& options) {
  const bool is_listed = run.options().generators.are_listed();
  if (!is_listed) run.console().detail(counted(std::ssize(start.points), "generator", "generators"));
  if (const std::int64_t faces = options.copy.faces.value_or(0); faces > 0 && !start.copy) {
    note_unused_copy(run, mesh, faces, start.points.size());
  }
  note_unfollowed_curves(run, start);
  if (start.freedom.empty()) return;
  const auto count_of = [&](Freedom kind) { return std::count(start.freedom.begin(), start.freedom.end(), kind); };
  const StartOptions& asked = options.constraints;
  const bool wants_creases = asked.crease_angle && !(asked.prefers_creases && is_listed);
  const char* const curves = wants_creases ? "creases or the boundary" : "the boundary";
  run.console().note(fmt::format("generators: {} fixed, {} on {}, {} free", count_of(Freedom::fixed),
                                 count_of(Freedom::on_crease), curves, count_of(Freedom::free)));
}

void show_iteration(Run& run, std::int64_t iterations, double energy) {
  run.console().set_status(fmt::format("iteration {}, energy {:.6g}", iterations, energy));
}

void note_copy(Run& run, const CoarseRelaxation& used, const RelaxationStart& start, bool ends_on_copy) {
  if (used.faces == 0 && start.copy) {
    run.console().note(
        fmt::format("the copy of {} faces is not used, because it is too large or generators coincide on it",
                    start.copy->mesh.face_count()));
  }
  if (used.faces == 0 || ends_on_copy) return;
  run.console().note(fmt::format("relaxed in {} on a copy of {} faces first",
                                 counted(used.iterations, "iteration", "iterations"), used.faces));
}

nlohmann::ordered_json describe_copy(const CoarseRelaxation& copy) {
  if (copy.faces == 0) return nullptr;
  return {{"faces", copy.faces}, {"iterations", copy.iterations}, {"diagrams", copy.diagrams}};
}

}  // namespace gvd::app
