#include "gvd/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geodesic/sampling/sampling_random.hpp"
#include "geodesic/sampling/sampling_steps.hpp"
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
    throw Error(ErrorCode::invalid_option, fmt::format("{} generators asked for; ask for at least 1", options.count));
  }
  // Whatever uses the generators adds a vertex for each of them.
  const std::int64_t most = std::int64_t{kMaxSamplingVertices} + mesh.vertex_count();
  if (options.count > most) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} generators asked for; on this mesh ask for at most {}", options.count, most));
  }
}

}  // namespace

double even_spacing(double area, std::int64_t count) {
  // Each point has two triangles of area sqrt(3) / 4 times the square of the side.
  return std::sqrt(2 * area / (std::numbers::sqrt3 * static_cast<double>(count)));
}

std::int64_t most_splits(const Mesh& mesh, std::int64_t count) {
  return std::min<std::int64_t>(4 * (mesh.vertex_count() + count), kMaxSamplingVertices);
}

std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options) {
  check_options(mesh, options);
  report_progress(options.progress, "sampling", 0);
  switch (options.kind) {
    case Sampling::farthest:
      return sample_farthest(mesh, options);
    case Sampling::random:
      return sample_random(mesh, options.count, options.seed);
    case Sampling::poisson:
      return sample_poisson(mesh, options);
    case Sampling::covering_radius:
      return sample_covering(mesh, options);
  }
  return {};
}

}  // namespace gvd
