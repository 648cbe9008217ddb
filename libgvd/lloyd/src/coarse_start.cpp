// A relaxation from coarse to fine: on a decimated copy of the mesh until it ends, and for a few iterations on the
// mesh.
//
// An iteration takes time in proportion to the faces, and the cells of few generators need few faces. The copy's energy
// has nearly the same minima as the mesh's. So the last generators on the copy, moved to the mesh, are near a minimum
// there, and what is left is to find their cells and to correct their places.
//
// Generators that may not move freely stay where they are until they are on the mesh: those on creases are evenly
// spaced from the start. They count on the copy, at the nearest point. Extremities are found on the copy.
#include "coarse_start.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "generator_moves.hpp"
#include "gvd/coarse_copy.hpp"

namespace gvd {
namespace {

/// Largest share of the mesh's faces that is worth a copy.
constexpr double kLargestShare = 0.5;

/// Share of the progress that the relaxation on the copy takes.
constexpr double kCopyShare = 0.3;

/// Energy tolerance on the copy, where the mesh has the default rule: iterations on the copy cost little.
constexpr double kCopyTolerance = 1e-5;

Freedom freedom_of(const LloydOptions& options, std::size_t i) {
  return options.freedom.empty() ? Freedom::free : options.freedom[i];
}

LloydOptions options_on_copy(const Mesh& mesh, const LloydOptions& options) {
  LloydOptions of_copy = options;
  of_copy.copy = nullptr;
  of_copy.creases.clear();
  for (Freedom& freedom : of_copy.freedom) freedom = freedom == Freedom::free ? Freedom::free : Freedom::fixed;
  of_copy.density = to_copy(mesh, *options.copy, options.density);
  of_copy.on_iteration = nullptr;
  if (!options.energy_tolerance) of_copy.energy_tolerance = kCopyTolerance;
  if (options.progress) {
    of_copy.progress = [&options](std::string_view step, double done) {
      return options.progress(step, kCopyShare * done);
    };
  }
  return of_copy;
}

/// The options of the iterations on the mesh. The copy's diagram has told which generators are on extremities.
LloydOptions options_on_mesh(const LloydOptions& options, const LloydResult& on_copy) {
  LloydOptions of_mesh = options;
  of_mesh.copy = nullptr;
  of_mesh.keeps_extremities = false;
  of_mesh.early_approximation = false;
  if (!options.energy_tolerance) {
    of_mesh.max_iterations = std::min(max_iterations(options), kFinishIterations);
    of_mesh.least_promise = std::max(options.least_promise, kFinishPromise);
  }
  if (!on_copy.extremities.empty()) of_mesh.freedom.resize(on_copy.generators.size(), Freedom::free);
  for (const GeneratorId g : on_copy.extremities) of_mesh.freedom[g.index()] = Freedom::fixed;
  if (options.progress) {
    of_mesh.progress = [&options](std::string_view step, double done) {
      return options.progress(step, kCopyShare + (1 - kCopyShare) * done);
    };
  }
  return of_mesh;
}

}  // namespace

std::optional<LloydResult> relax_from_copy(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                           const LloydOptions& options) {
  const CoarseCopy& copy = *options.copy;
  if (max_iterations(options) == 0 || (options.is_time_over && options.is_time_over())) return std::nullopt;
  if (copy.mesh.face_count() > kLargestShare * mesh.face_count()) return std::nullopt;
  std::vector<SurfacePoint> start;
  for (const SurfacePoint& p : generators) start.push_back(to_copy(mesh, copy, p));
  if (!are_apart(copy.mesh, start)) return std::nullopt;
  LloydResult on_copy = relax_generators(copy.mesh, start, options_on_copy(mesh, options));
  std::vector<SurfacePoint> moved = generators;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (freedom_of(options, i) == Freedom::free) moved[i] = to_input(mesh, copy, on_copy.generators[i]);
  }
  keep_apart(mesh, generators, coincidence(mesh), moved);
  LloydResult result = relax_generators(mesh, moved, options_on_mesh(options, on_copy));
  const bool ends_early = !options.energy_tolerance && max_iterations(options) > kFinishIterations;
  if (ends_early && result.stop == LloydStop::max_iterations) result.stop = LloydStop::prediction;
  result.extremities = std::move(on_copy.extremities);
  result.copy = {copy.mesh.face_count(), std::ssize(on_copy.iterations), on_copy.diagrams};
  return result;
}

}  // namespace gvd
