// Spreads generators over the surface: checks the options, and calls the sampler that they name.
//
// Source: the papers named in gvd/sampling.hpp; drawing vertices is the beginning of a shuffle by Fisher and Yates.
// Invariant: a sampler gets options in their ranges, so that it throws only where the mesh has no room.
#include "gvd/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "geodesic/sampling/samplers.hpp"
#include "geodesic/sampling/sampling_random.hpp"
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

double even_spacing(double area, std::int64_t count) {
  // Each point has two triangles of area sqrt(3) / 4 times the square of the side.
  return std::sqrt(2 * area / (std::numbers::sqrt3 * double(count)));
}

double even_count(double area, double spacing) {
  return std::max(1.0, std::round(2 * area / (std::numbers::sqrt3 * spacing * spacing)));
}

std::int64_t max_splits(const Mesh& mesh, std::int64_t count) {
  return std::min<std::int64_t>(4 * (mesh.vertex_count() + count), kMaxSamplingVertices);
}

std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  const IdRange<VertexId> all = mesh.vertices();
  std::vector<VertexId> order(all.begin(), all.end());
  SeededRandom random(seed);
  for (std::int64_t i = 0; i < count; ++i) std::swap(order[i], order[i + random.below(order.size() - i)]);
  order.resize(count);
  return order;
}

std::vector<SurfacePoint> sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  if (count > mesh.vertex_count()) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("{} different vertices asked for, and the mesh has {}; ask for fewer, or take random points", count,
                    mesh.vertex_count()));
  }
  std::vector<SurfacePoint> points;
  for (const VertexId v : draw_vertices(mesh, count, seed)) points.push_back(vertex_point(mesh, v));
  return points;
}

}  // namespace gvd
