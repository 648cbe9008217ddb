// Goes from options to the start of a relaxation.
//
// The number of generators decides the size of the copy, and farthest points are sampled on the copy. So the copy is
// made first if the number is known, and otherwise after the generators were listed or sampled for a covering radius.

#include "gvd/relaxation_start.hpp"

#include <utility>
#include <variant>
#include <vector>

#include "copy_points.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// The number of faces of the copy for this many generators; 0 for no copy.
std::int64_t choose_copy_faces(std::int64_t all, std::int64_t generators, const RelaxationStartOptions& options) {
  if (options.sample) return 0;
  const CopyOptions& asked = options.copy;
  const std::int64_t by_default = all > asked.above ? default_copy_faces(all, generators, asked.size) : 0;
  const std::int64_t faces = asked.faces.value_or(by_default);
  return faces < kCopyFacesPerGenerator * generators || 2 * faces > all ? 0 : faces;
}

/// The constraints of the generators. Listed generators do not follow preferred creases.
StartOptions choose_constraints(const RelaxationStartOptions& options) {
  StartOptions constraints = options.constraints;
  constraints.are_listed = !options.listed.empty();
  constraints.progress = options.progress;
  if (constraints.are_listed && constraints.prefers_creases) {
    constraints.prefers_creases = false;
    constraints.crease_angle.reset();
  }
  return constraints;
}

}  // namespace

CopyOptions copy_options(const LloydOptions& relaxation, CopyOptions asked) {
  const bool compares = relaxation.acceleration != Acceleration::lbfgs && !asked.faces;
  if (compares || max_iterations(relaxation) == 0) asked.faces = 0;
  return asked;
}

RelaxationStart start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options) {
  return value_or_throw(try_to_start_relaxation(mesh, options));
}

OrError<RelaxationStart> try_to_start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options) {
  if (options.copy.faces.value_or(0) < 0) {
    throw Error(ErrorCode::invalid_option, "the number of a copy's faces must not be negative");
  }
  const auto enter = [&](std::string_view step) {
    if (options.on_step) options.on_step(step);
  };
  RelaxationStart start;
  const auto make_copy = [&](std::int64_t generators) {
    const std::int64_t faces = choose_copy_faces(mesh.face_count(), generators, options);
    if (faces == 0) return;
    enter("coarse copy");
    start.copy = make_coarse_copy(mesh, faces, options.threads, options.progress);
  };
  std::vector<SurfacePoint> points = options.listed;
  const bool knows_count = points.empty() && options.sampling.kind != Sampling::covering_radius;
  if (knows_count) make_copy(options.sampling.count);
  if (points.empty()) {
    enter("generators");
    SamplingOptions sampling = options.sampling;
    sampling.progress = options.progress;
    const bool on_copy = start.copy && sampling.kind == Sampling::farthest;
    OrError<std::vector<SurfacePoint>> sampled = options.sample ? options.sample(sampling)
                                                 : on_copy      ? sample_on_copy(mesh, *start.copy, sampling)
                                                                : try_to_sample_generators(mesh, sampling);
    if (Error* const error = std::get_if<Error>(&sampled)) return std::move(*error);
    points = std::get<std::vector<SurfacePoint>>(std::move(sampled));
  }
  const std::int64_t count = std::ssize(points);
  if (!knows_count && options.copy.faces) make_copy(count);
  start.density = options.density;
  if (options.weighs_curvature) {
    enter("density");
    start.density = make_curvature_density(mesh, count, {.gradation = options.gradation, .progress = options.progress});
  }
  enter("constraints");
  auto constrained = constrain_start(mesh, std::move(points), choose_constraints(options));
  if (Error* const error = std::get_if<Error>(&constrained)) return std::move(*error);
  static_cast<ConstrainedStart&>(start) = std::get<ConstrainedStart>(std::move(constrained));
  return start;
}

LloydResult relax_generators(const Mesh& mesh, const RelaxationStart& start, LloydOptions options, LloydStages stages) {
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  stages.copy = start.copy ? &*start.copy : nullptr;
  return relax_generators(mesh, start.points, options, stages);
}

}  // namespace gvd
