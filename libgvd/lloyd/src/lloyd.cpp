// Runs a relaxation in stages: on a decimated copy of the mesh until it ends, for a few iterations on the mesh
// (relaxer.hpp), and with generators on extremities.
//
// The time of an iteration is proportional to the number of faces, but the cells of few generators need only few faces.
// The energy on the copy has nearly the same minima as the energy on the mesh. So the final generators of the copy,
// moved to the mesh, are near a minimum there, and it only remains to find their cells and correct their places.
//
// Generators that may not move freely take part on the copy, at the nearest point, but do not move there; generators on
// creases are evenly spaced from the start. Extremities are found on the copy.
//
// The centroid of a cell around the end of a limb lies beside the end, so a relaxation pulls generators off limbs.
// keep_extremities puts them back: the end of a limb is a place inside a cell where the distance from the generator has
// a maximum, whereas in cells of flat or hollow surfaces, distances are largest on the border.

#include "gvd/lloyd.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "copy_points.hpp"
#include "diagram/diagram_windows.hpp"
#include "generator_moves.hpp"
#include "gvd/error.hpp"
#include "relaxer.hpp"

namespace gvd {
namespace {

/// The least distance of an extremity from its generator, in radii of a disc with the cell's area. Nearer ones are
/// spikes much smaller than the cell.
constexpr double kLeastExtremity = 0.5;

/// Number of iterations after generators moved to extremities. Further ones hardly reduce the distance of remeshes.
constexpr std::int32_t kExtremityIterations = 5;

/// Largest share of cells that stop being discs, or get fewer than three neighbours, when generators move to
/// extremities. With more, repairing the remesh costs more than extremities gain.
constexpr double kLargestPoorShare = 0.04;

/// Largest share of generators on extremities. On surfaces with limbs 2 to 5 % of the generators are there, and on
/// rough surfaces more than half.
constexpr double kLargestExtremityShare = 0.2;

/// The share of the progress before generators move to extremities.
constexpr double kShareBefore = 0.75;

void check_options(const LloydOptions& o) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::invalid_option, message); };
  if (max_iterations(o) < 0) refuse("the number of iterations must not be negative");
  const double tolerance = energy_tolerance(o).value_or(0);
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) refuse("the energy tolerance must be 0 or more");
  if (!(o.move_tolerance >= 0) || !std::isfinite(o.move_tolerance)) refuse("the move tolerance must be 0 or more");
  check_diagram_options(o.diagram);  // iterations without diagrams would not check them
}

/// Maps the progress of a part of the relaxation to the range from `begin` to `end` of the whole.
Progress part_of(const Progress& whole, double begin, double end) {
  if (!whole) return {};
  return [whole, begin, end](std::string_view step, double done) { return whole(step, begin + (end - begin) * done); };
}

constexpr std::string_view kRelaxation = "relaxation";

/// A copy is worthwhile if it has at most this share of the mesh's faces.
constexpr double kLargestShare = 0.5;

/// The share of the progress for the relaxation on the copy.
constexpr double kCopyShare = 0.3;

/// The least energy tolerance on the copy. The default rule would end at larger energies, and with a smaller tolerance
/// the result is no nearer to the minimum on the mesh.
constexpr double kCopyTolerance = 1e-5;

Freedom freedom_of(const LloydOptions& options, std::size_t i) {
  return options.freedom.empty() ? Freedom::free : options.freedom[i];
}

LloydOptions options_on_copy(const Mesh& mesh, const LloydOptions& options, const CoarseCopy& copy) {
  LloydOptions of_copy = options;
  of_copy.creases.clear();
  for (Freedom& freedom : of_copy.freedom) freedom = freedom == Freedom::free ? Freedom::free : Freedom::fixed;
  of_copy.density = to_copy(mesh, copy, options.density);
  of_copy.on_iteration = nullptr;
  of_copy.energy_tolerance = std::max(kCopyTolerance, options.energy_tolerance.value_or(0));
  of_copy.progress = part_of(options.progress, 0, kCopyShare);
  return of_copy;
}

/// The number of iterations that are left for the mesh. Iterations for extremities of the copy come on top of the
/// others, so that there may be more on the copy than are allowed.
std::int32_t iterations_left(const LloydOptions& options, const LloydResult& on_copy) {
  return std::max(0, max_iterations(options) - static_cast<std::int32_t>(on_copy.iterations.size()));
}

/// The options for the iterations on the mesh. Generators on extremities, which were found on the copy, stay fixed.
LloydOptions options_on_mesh(const LloydOptions& options, const LloydResult& on_copy) {
  LloydOptions of_mesh = options;
  of_mesh.max_iterations = iterations_left(options, on_copy);
  if (!options.energy_tolerance) of_mesh.max_iterations = std::min(*of_mesh.max_iterations, kFinishIterations);
  if (!on_copy.extremities.empty()) of_mesh.freedom.resize(on_copy.generators.size(), Freedom::free);
  for (const GeneratorId g : on_copy.extremities) of_mesh.freedom[g.index()] = Freedom::fixed;
  of_mesh.progress = part_of(options.progress, kCopyShare, 1);
  return of_mesh;
}

/// Moves the generators to the copy. Returns nothing if the copy can't be used: no iteration is left, it has more than
/// half of the mesh's faces, or generators that are apart on the mesh coincide on it.
std::optional<std::vector<SurfacePoint>> start_on_copy(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                                       const LloydOptions& options, const CoarseCopy& copy) {
  if (max_iterations(options) == 0 || (options.is_time_over && options.is_time_over())) return std::nullopt;
  if (copy.mesh.face_count() > kLargestShare * mesh.face_count()) return std::nullopt;
  std::vector<SurfacePoint> start = to_copy(mesh, copy, generators, options.progress, {kRelaxation, 0, 0});
  if (!are_apart(copy.mesh, start)) return std::nullopt;
  return start;
}

/// Moves the generators of the copy back to the mesh. Generators that are not free are where they were.
std::vector<SurfacePoint> back_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                       const LloydOptions& options, const CoarseCopy& copy,
                                       const std::vector<SurfacePoint>& on_copy) {
  std::vector<SurfacePoint> moved =
      to_input(mesh, copy, on_copy, options.progress, {kRelaxation, kCopyShare, kCopyShare});
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (freedom_of(options, i) != Freedom::free) moved[i] = generators[i];
  }
  keep_apart(mesh, generators, coincidence(mesh), moved);
  return moved;
}

CoarseRelaxation sum_up(const CoarseCopy& copy, const LloydResult& on_copy) {
  return {copy.mesh.face_count(), std::ssize(on_copy.iterations), on_copy.diagrams};
}

/// Runs a relaxation without extremities, on the mesh or entirely on the copy. In the latter case, energies and moments
/// belong to the copy and the diagram to the mesh.
LloydResult relax_once(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options,
                       const LloydStages& stages) {
  RelaxerRules rules{.starts_by_faces = stages.early_approximation};
  const CoarseCopy* const copy = stages.ends_on_copy ? stages.copy : nullptr;
  const auto start = copy ? start_on_copy(mesh, generators, options, *copy) : std::nullopt;
  if (!start) return relax_on_mesh(mesh, generators, options, rules);
  rules.ends_by_faces = true;
  LloydResult result = relax_on_mesh(copy->mesh, *start, options_on_copy(mesh, options, *copy), rules);
  result.copy = sum_up(*copy, result);
  result.generators = back_on_mesh(mesh, generators, options, *copy, result.generators);
  DiagramOptions of_mesh = options.diagram;
  of_mesh.progress = part_of(options.progress, kCopyShare, 1);
  result.diagram = compute_diagram(mesh, result.generators, of_mesh);
  result.diagrams = 1;
  return result;
}

/// Whether a vertex is an extremity: it is in the same cell as all its neighbours, and farther from the generator than
/// they are.
bool is_extremity(const Mesh& mesh, const Diagram& diagram, VertexId v) {
  const GeneratorId g = diagram.vertex_label[v];
  if (!g.valid() || !mesh.halfedge(v).valid() || mesh.is_boundary(v)) return false;
  const double distance = diagram.vertex_distance[v];
  if (distance < kLeastExtremity * std::sqrt(diagram.cells[g].area / std::numbers::pi)) return false;
  HalfedgeId h = mesh.halfedge(v);
  do {
    const VertexId w = mesh.to(h);
    if (diagram.vertex_label[w] != g || !(diagram.vertex_distance[w] < distance)) return false;
    h = mesh.twin(Mesh::previous(h));
  } while (h != mesh.halfedge(v));
  return true;
}

/// The farthest extremity of each cell; invalid if there is none.
IdVector<GeneratorId, VertexId> find_extremities(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, VertexId> farthest(diagram.generators.size());
  for (const VertexId v : mesh.vertices()) {
    if (!is_extremity(mesh, diagram, v)) continue;
    VertexId& best = farthest[diagram.vertex_label[v]];
    if (!best.valid() || diagram.vertex_distance[v] > diagram.vertex_distance[best]) best = v;
  }
  return farthest;
}

/// The number of cells that a remesh would have to repair, because they are not discs or have fewer than three
/// neighbours.
std::int64_t count_poor_cells(const Diagram& diagram) {
  return std::ranges::count_if(diagram.cells, [](const Cell& cell) {
    return cell.euler_characteristic != 1 || (cell.boundary_loops == 1 && cell.neighbours.size() < 3);
  });
}

/// Moves free generators to the extremities of their cells, where they stay, and relaxes the other generators once
/// more. Changes nothing if there are too few generators for the limbs.
void keep_extremities(const Mesh& mesh, const LloydOptions& options, const LloydStages& stages, LloydResult& result) {
  LloydOptions again = options;
  again.freedom.resize(result.generators.size(), Freedom::free);
  std::vector<SurfacePoint> start = result.generators;
  std::vector<GeneratorId> kept;
  const IdVector<GeneratorId, VertexId> extremities = find_extremities(mesh, result.diagram);
  for (const GeneratorId g : extremities.ids()) {
    if (!extremities[g].valid() || again.freedom[g.index()] != Freedom::free) continue;
    start[g.index()] = vertex_point(mesh, extremities[g]);
    again.freedom[g.index()] = Freedom::fixed;
    kept.push_back(g);
  }
  if (kept.empty() || double(kept.size()) > kLargestExtremityShare * double(start.size())) return;
  // Only few generators have moved, so the model predicts only a small fall. On the mesh all iterations are made
  // regardless.
  again.energy_tolerance = energy_tolerance(options).value_or(0);
  again.max_iterations = std::min(max_iterations(options), kExtremityIterations);
  LloydResult second = relax_once(mesh, start, again, stages);
  const double more = double(count_poor_cells(second.diagram) - count_poor_cells(result.diagram));
  if (more > kLargestPoorShare * double(start.size())) return;
  second.extremities = std::move(kept);
  second.initial_energy = result.initial_energy;
  second.diagrams += result.diagrams;
  second.copy.iterations += result.copy.iterations;
  second.copy.diagrams += result.copy.diagrams;
  second.iterations.insert(second.iterations.begin(), result.iterations.begin(), result.iterations.end());
  result = std::move(second);
}

/// Runs a relaxation, with extremities if the stages ask for them.
LloydResult relax_with_extremities(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                   const LloydOptions& options, const LloydStages& stages) {
  if (!stages.keeps_extremities) return relax_once(mesh, generators, options, stages);
  LloydOptions part = options;
  part.progress = part_of(options.progress, 0, kShareBefore);
  LloydResult result = relax_once(mesh, generators, part, stages);
  part.progress = part_of(options.progress, kShareBefore, 1);
  keep_extremities(mesh, part, stages, result);
  return result;
}

/// Relaxes on the copy, with extremities, from the generators `start`, and then does a few iterations on the mesh.
LloydResult finish_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                           const std::vector<SurfacePoint>& start, const LloydOptions& options,
                           const LloydStages& stages) {
  const CoarseCopy& copy = *stages.copy;
  LloydStages of_copy = stages;
  of_copy.copy = nullptr;
  LloydResult on_copy = relax_with_extremities(copy.mesh, start, options_on_copy(mesh, options, copy), of_copy);
  const std::vector<SurfacePoint> moved = back_on_mesh(mesh, generators, options, copy, on_copy.generators);
  const double least_promise = options.energy_tolerance ? 0 : kFinishPromise;
  LloydResult result = relax_on_mesh(mesh, moved, options_on_mesh(options, on_copy),
                                     {.starts_by_faces = false, .least_promise = least_promise});
  const bool ends_early = !options.energy_tolerance && iterations_left(options, on_copy) > kFinishIterations;
  if (ends_early && result.stop == LloydStop::max_iterations) result.stop = LloydStop::prediction;
  result.extremities = std::move(on_copy.extremities);
  result.copy = sum_up(copy, on_copy);
  return result;
}

}  // namespace

LloydResult relax_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options,
                             const LloydStages& stages) {
  check_options(options);
  check_density(mesh, options.density);
  if (generators.empty()) throw Error(ErrorCode::precondition, "there are no generators to relax");
  if (stages.copy && !stages.ends_on_copy) {
    if (const auto start = start_on_copy(mesh, generators, options, *stages.copy)) {
      return finish_on_mesh(mesh, generators, *start, options, stages);
    }
  }
  return relax_with_extremities(mesh, generators, options, stages);
}

}  // namespace gvd
