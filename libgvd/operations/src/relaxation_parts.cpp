// Steps that the operations that relax generators share: the start from the options, and notes and figures of the
// result.

#include "gvd/relaxation_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "figures.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

std::vector<SurfacePoint> resolve_fixed(const CheckedMesh& input, const GivenPoints& given, Observer& observer) {
  if (!given.is_given()) return {};
  ResolvedGenerators fixed =
      resolve_generators(input.mesh, list_points(given, "\1fixed\2"), {.input_vertices = &input.mesh_vertex});
  note_far_entry(observer, fixed, input.mesh.bbox_diagonal());
  return std::move(fixed.points);
}

/// Notes which curves the generators do not follow although they should, and how many generators would suffice.
void note_unfollowed_curves(Observer& observer, const ConstrainedStart& start) {
  if (start.unfollowed_loops > 0) {
    observer.note(
        fmt::format("boundary: {} of {} not followed, because this would take more than half of the generators; "
                    "\1count={}\2 puts some on each",
                    start.unfollowed_loops, counted(start.loops, "loop is", "loops are"), start.enough_for_loops));
  }
  if (start.leaves_creases) {
    const std::string enough =
        start.enough_for_creases > 0 ? fmt::format("\1count={}\2 or ", start.enough_for_creases) : std::string();
    observer.note(
        fmt::format("creases: not followed, because this would take too many of the generators; "
                    "{}\1features={}\2 follows them",
                    enough, kUsualCreaseAngle));
  }
}

/// Notes why a requested copy is not used.
void note_unused_copy(Observer& observer, const Mesh& mesh, std::int64_t faces, std::size_t generators) {
  const bool is_small = faces < kCopyFacesPerGenerator * std::int64_t(generators);
  const std::string reason = is_small ? fmt::format("it has less than {} faces for a generator", kCopyFacesPerGenerator)
                                      : fmt::format("the mesh has {} faces", mesh.face_count());
  observer.note(fmt::format("\1coarse={}\2: not used, because {}", faces, reason));
}

}  // namespace

void describe(OptionList& list, GivenConstraints& given) {
  list.group("Constraints");
  list.option("fixed", PointList{&given.fixed, PointList::Named::file},
              {.help = "File that lists generators to keep in place",
               .more = "; \1count\2 includes them",
               .arrays = "Points that are generators to keep in place; \1count\2 includes them"});
  list.option("density", ValueSource{&given.density, {"curvature"}},
              {.help = "Weight of the surface, above 0, which makes cells smaller where it is larger",
               .more = ": 'curvature', a file with a number for each vertex or each face (text, .npy, .shape.gii or "
                       "FreeSurfer's), or the name of a property of a PLY, VTP or VTU input",
               .arrays = "Weight of the surface, above 0, which makes cells smaller where it is larger: 'curvature', "
                         "or a number for each vertex or each face"});
  list.rule({"gradation", {"density"}, [&given](const Given&) -> std::string {
               if (given.density.name == "curvature") return "";
               return "\1gradation\2 needs \1density=curvature\2: add it, or leave \1gradation\2 out";
             }});
}

Density find_density(const CheckedMesh& input, const GivenNumbers& given) {
  return given.values ? make_density(input, *given.values) : Density();
}

RelaxationStartOptions make_start_options(const CheckedMesh& input, const GeneratorOptions& generators,
                                          const DiagramOptions& diagram, const GivenConstraints& given,
                                          RelaxationStartOptions options, ResolvedGenerators& listed,
                                          Observer& observer) {
  if (generators.are_listed()) {
    listed = choose_generators(input, generators, diagram, observer);
    options.listed = listed.points;
  }
  options.sampling = make_sampling_options(generators, diagram, observer);
  options.constraints.fixed = resolve_fixed(input, given.fixed, observer);
  options.weighs_curvature = given.density.name == "curvature";
  if (!options.weighs_curvature) options.density = find_density(input, given.density);
  options.threads = observer.threads;
  options.progress = progress_of(observer);
  return options;
}

std::vector<std::optional<double>> snaps_of_unmoved(const ResolvedGenerators& listed,
                                                    const std::vector<SurfacePoint>& points) {
  std::vector<std::optional<double>> snaps(points.size());
  for (std::size_t i = 0; i < std::min(points.size(), listed.points.size()); ++i) {
    if (listed.points[i] == points[i]) snaps[i] = listed.snap_distance[i];
  }
  return snaps;
}

void tell_start(Observer& observer, const Mesh& mesh, const RelaxationStart& start,
                const RelaxationStartOptions& options, bool is_listed) {
  if (!is_listed) observer.detail(counted(std::ssize(start.points), "generator", "generators"));
  if (const std::int64_t faces = options.copy.faces.value_or(0); faces > 0 && !start.copy) {
    note_unused_copy(observer, mesh, faces, start.points.size());
  }
  note_unfollowed_curves(observer, start);
  if (start.freedom.empty()) return;
  const auto count_of = [&](Freedom kind) { return std::count(start.freedom.begin(), start.freedom.end(), kind); };
  const StartOptions& asked = options.constraints;
  const bool wants_creases = asked.crease_angle && !(asked.prefers_creases && is_listed);
  const char* const curves = wants_creases ? "creases or the boundary" : "the boundary";
  observer.note(fmt::format("generators: {} fixed, {} on {}, {} free", count_of(Freedom::fixed),
                            count_of(Freedom::on_crease), curves, count_of(Freedom::free)));
}

void show_iteration(Observer& observer, std::int64_t iterations, double energy) {
  observer.status(fmt::format("iteration {}, energy {:.6g}", iterations, energy));
}

void tell_copy(Observer& observer, const CoarseRelaxation& used, const RelaxationStart& start, bool ends_on_copy) {
  if (used.faces == 0 && start.copy) {
    observer.note(fmt::format("the copy of {} faces is not used, because it is too large or generators coincide on it",
                              start.copy->mesh.face_count()));
  }
  if (used.faces == 0 || ends_on_copy) return;
  observer.note(fmt::format("relaxed in {} on a copy of {} faces first",
                            counted(used.iterations, "iteration", "iterations"), used.faces));
}

void visit_copy(ObjectVisitor& visitor, const CoarseRelaxation& copy, const std::string& name) {
  const Figures figure(visitor, name, copy.faces > 0);
  figure("faces", "", "of the copy of the mesh that was relaxed on first", copy.faces);
  figure("iterations", "", "on the copy", copy.iterations);
  figure("diagrams", "", "of the copy", copy.diagrams);
}

}  // namespace gvd
