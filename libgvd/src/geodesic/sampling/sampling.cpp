#include "gvd/sampling.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geodesic/sampling/sampling_farthest.hpp"
#include "geodesic/sampling/sampling_poisson.hpp"
#include "geodesic/sampling/sampling_random.hpp"
#include "geodesic/sampling/sampling_vertices.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

void check_options(const Mesh& mesh, const SamplingOptions& options) {
  if (mesh.face_count() == 0) throw Error(ErrorCode::precondition, "the mesh has no face to put a generator on");
  if (options.kind == Sampling::covering_radius) {
    if (options.radius > 0 && std::isfinite(options.radius)) return;
    throw Error(ErrorCode::invalid_option,
                fmt::format("the covering radius is {}; give a number above 0", options.radius));
  }
  if (options.count < 1) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("the number of generators is {}; ask for at least 1", options.count));
  }
  // The working mesh adds a vertex for each generator.
  const std::int64_t maximum = std::int64_t{kMaxSamplingVertices} + mesh.vertex_count();
  if (options.count > maximum) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} generators asked for; on this mesh ask for at most {}", options.count, maximum));
  }
}

}  // namespace

std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options) {
  check_options(mesh, options);
  report_progress(options.progress, "sampling", 0);
  switch (options.kind) {
    case Sampling::farthest:
      return sample_farthest(mesh, options);
    case Sampling::random:
      return sample_random(mesh, options.count, options.seed);
    case Sampling::vertices:
      return sample_vertices(mesh, options.count, options.seed);
    case Sampling::poisson:
      return sample_poisson(mesh, options);
    case Sampling::covering_radius:
      return sample_covering(mesh, options);
  }
  return {};
}

}  // namespace gvd
