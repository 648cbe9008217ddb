// The steps from options to the start of a relaxation.
//
// The number of generators decides the size of the copy, and farthest points are sampled on the copy. So it comes first
// where the number is known, and after the generators of a list or of a covering radius.

#include "gvd/relaxation_start.hpp"

#include <utility>

#include "gvd/error.hpp"

namespace gvd {
namespace {

class Starter {
 public:
  Starter(const Mesh& mesh, const RelaxationStartOptions& options) : mesh_(mesh), options_(options) {}

  RelaxationStart start() {
    RelaxationStart made;
    std::vector<SurfacePoint> points = options_.listed;
    const bool knows_count = points.empty() && options_.sampling.kind != Sampling::covering_radius;
    if (knows_count) made.copy = make_copy(options_.sampling.count);
    if (points.empty()) points = sample(made.copy);
    if (!knows_count && options_.copy.faces) made.copy = make_copy(std::ssize(points));
    made.density = make_density(std::ssize(points));
    enter("constraints");
    static_cast<ConstrainedStart&>(made) = constrain_start(mesh_, std::move(points), constraints());
    return made;
  }

 private:
  void enter(std::string_view step) const {
    if (options_.on_step) options_.on_step(step);
  }

  std::optional<CoarseCopy> make_copy(std::int64_t generators) const {
    if (options_.sample) return std::nullopt;
    const CopyOptions& asked = options_.copy;
    const std::int64_t all = mesh_.face_count();
    const std::int64_t by_default = all > asked.above ? default_copy_faces(all, generators, asked.size) : 0;
    const std::int64_t faces = asked.faces.value_or(by_default);
    if (faces == 0 || faces < kCopyFacesPerGenerator * generators || 2 * faces > all) return std::nullopt;
    enter("coarse copy");
    return make_coarse_copy(mesh_, faces, options_.threads, options_.progress);
  }

  std::vector<SurfacePoint> sample(const std::optional<CoarseCopy>& copy) const {
    enter("generators");
    SamplingOptions sampling = options_.sampling;
    sampling.progress = options_.progress;
    if (options_.sample) return options_.sample(sampling);
    const bool on_copy = copy && sampling.kind == Sampling::farthest;
    return on_copy ? sample_on_copy(mesh_, *copy, sampling) : sample_generators(mesh_, sampling);
  }

  Density make_density(std::int64_t generators) const {
    if (!options_.weighs_curvature) return options_.density;
    enter("density");
    return make_curvature_density(mesh_, generators, {.gradation = options_.gradation, .progress = options_.progress});
  }

  StartOptions constraints() const {
    StartOptions constraints = options_.constraints;
    constraints.are_listed = !options_.listed.empty();
    constraints.progress = options_.progress;
    if (constraints.are_listed && constraints.prefers_creases) {
      constraints.prefers_creases = false;
      constraints.crease_angle.reset();
    }
    return constraints;
  }

  const Mesh& mesh_;
  const RelaxationStartOptions& options_;
};

}  // namespace

CopyOptions copy_options(const LloydOptions& relaxation, CopyOptions asked) {
  const bool compares = relaxation.acceleration != Acceleration::lbfgs && !asked.faces;
  if (compares || max_iterations(relaxation) == 0) asked.faces = 0;
  return asked;
}

RelaxationStart start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options) {
  if (options.copy.faces.value_or(0) < 0) {
    throw Error(ErrorCode::invalid_option, "the number of a copy's faces must not be negative");
  }
  return Starter(mesh, options).start();
}

LloydResult relax_generators(const Mesh& mesh, const RelaxationStart& start, LloydOptions options, LloydStages stages) {
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  stages.copy = start.copy ? &*start.copy : nullptr;
  return relax_generators(mesh, start.points, options, stages);
}

}  // namespace gvd
