// Spreads generators over the surface: checks the options, calls the sampler that they name, and draws random points
// and vertices.
//
// Random points: the sums of the faces' areas cut an interval into pieces. A uniform number in it draws a face, two
// more a point of the face. Points that coincide within rounding are drawn again. Vertices are the beginning of a
// shuffle. Blue noise is in sampling_poisson.cpp, farthest points are in sampling_farthest.cpp.
// Source: G. Turk, Generating random points in triangles, 1990; the shuffle of Fisher and Yates.
// Invariant: a sampler gets options in their ranges, so that it throws only if the mesh has no room. All random numbers
// come from one engine, in an order that depends on the mesh and the count alone, so that the same seed gives the same
// points on every platform.
#include "gvd/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/barycentric.hpp"
#include "geodesic/sampling/samplers.hpp"
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
}

/// Points closer than kMinSampleSpacing to others are drawn again, at most this often. Usually no point has to be.
constexpr int kMaxRedraws = 64;

/// Points drawn between two reports of progress.
constexpr std::size_t kDrawStride = 1 << 6;

/// The later point of each pair that is too close. The distance is Euclidean on purpose, so that points on two sheets
/// that touch are kept apart, too.
std::vector<std::size_t> find_too_close(const std::vector<Vec3>& positions, double least, const Progress& progress) {
  // Sweep along a direction to which faces of ordinary models are not perpendicular.
  const Vec3 direction = Vec3(0.6180339887, 0.3819660113, 0.2360679775).normalized();
  std::vector<std::pair<double, std::size_t>> order(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) order[i] = {direction.dot(positions[i]), i};
  report_progress(progress, "sampling", 0);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> too_close;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kSweepStride == 0) report_progress(progress, "sampling", 0);
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= least; ++k) {
      const auto [earlier, later] = std::minmax(order[i].second, order[k].second);
      if ((positions[earlier] - positions[later]).norm() <= least) too_close.push_back(later);
    }
  }
  std::sort(too_close.begin(), too_close.end());
  too_close.erase(std::unique(too_close.begin(), too_close.end()), too_close.end());
  return too_close;
}

/// Vertices of `draw_vertices` as surface points.
SampledPoints sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  if (count > mesh.vertex_count()) {
    return Error(
        ErrorCode::precondition,
        fmt::format("{} different vertices were asked for, but the mesh has {}; ask for fewer, or take random points",
                    count, mesh.vertex_count()));
  }
  std::vector<SurfacePoint> points;
  for (const VertexId v : draw_vertices(mesh, count, seed)) points.push_back(vertex_point(mesh, v));
  return points;
}

}  // namespace

std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options) {
  return value_or_throw(try_to_sample_generators(mesh, options));
}

SampledPoints try_to_sample_generators(const Mesh& mesh, const SamplingOptions& options) {
  check_options(mesh, options);
  // The working mesh adds a vertex for each generator.
  const std::int64_t maximum = std::int64_t{kMaxSamplingVertices} + mesh.vertex_count();
  if (options.kind != Sampling::covering_radius && options.count > maximum) {
    return Error(ErrorCode::precondition,
                 fmt::format("{} generators were asked for; on this mesh, ask for at most {}", options.count, maximum));
  }
  report_progress(options.progress, "sampling", 0);
  switch (options.kind) {
    case Sampling::farthest:
      return sample_farthest(mesh, options);
    case Sampling::random:
      return sample_random(mesh, options.count, options);
    case Sampling::vertices:
      return sample_vertices(mesh, options.count, options.seed);
    case Sampling::poisson:
      return sample_poisson(mesh, options);
    case Sampling::covering_radius:
      return sample_covering(mesh, options);
  }
  return SampledPoints();
}

double even_spacing(double area, std::int64_t count) {
  // Each point has two triangles of area sqrt(3) / 4 times the square of the side.
  return std::sqrt(2 * area / (std::numbers::sqrt3 * double(count)));
}

double even_count(double area, double spacing) {
  return std::max(1.0, std::round(2 * area / (std::numbers::sqrt3 * spacing * spacing)));
}

SampledPoints sample_random(const Mesh& mesh, std::int64_t count, const SamplingOptions& options) {
  require_area(mesh);
  const AreaSampler sampler(mesh, list_faces(mesh));
  SeededRandom random(options.seed);
  std::vector<SurfacePoint> points(count);
  std::vector<Vec3> positions(count);
  const auto draw = [&](std::size_t i) {
    if (i % kDrawStride == 0) report_progress(options.progress, "sampling", 0);
    points[i] = sampler.draw_point(random);
    positions[i] = position(mesh, points[i]);
  };
  for (std::size_t i = 0; i < points.size(); ++i) draw(i);
  for (int round = 0; round < kMaxRedraws; ++round) {
    const auto too_close = find_too_close(positions, kMinSampleSpacing * mesh.bbox_diagonal(), options.progress);
    if (too_close.empty()) return points;
    for (const std::size_t i : too_close) draw(i);
  }
  return Error(ErrorCode::precondition,
               fmt::format("the surface is too small compared with its bounding box for {} different "
                           "points; ask for fewer, or remove far parts",
                           count));
}

std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  const IdRange<VertexId> all = mesh.vertices();
  std::vector<VertexId> order(all.begin(), all.end());
  SeededRandom random(seed);
  for (std::int64_t i = 0; i < count; ++i) std::swap(order[i], order[i + random.below(order.size() - i)]);
  order.resize(count);
  return order;
}

std::vector<FaceId> list_faces(const Mesh& mesh) {
  const IdRange<FaceId> faces = mesh.faces();
  return {faces.begin(), faces.end()};
}

double require_area(const Mesh& mesh) {
  const double area = compute_area(mesh);
  if (area > 0 && std::isfinite(area)) return area;
  throw Error(ErrorCode::precondition,
              "random points need a surface whose area is finite and not 0; take farthest points, or scale the mesh");
}

AreaSampler::AreaSampler(const Mesh& mesh, std::vector<FaceId> faces) : faces_(std::move(faces)) {
  sums_.reserve(faces_.size() + 1);
  sums_.push_back(0);
  for (const FaceId f : faces_) sums_.push_back(sums_.back() + mesh.area(f));
}

FaceId AreaSampler::draw_face(SeededRandom& random, std::size_t first, std::size_t last) const {
  const double target = sums_[first] + random.real() * (sums_[last] - sums_[first]);
  // The first face whose cumulated area exceeds the target; a face with zero area is never chosen.
  const double* const sums = sums_.data();
  return faces_[std::upper_bound(sums + first + 1, sums + last, target) - sums - 1];
}

SurfacePoint AreaSampler::draw_point(SeededRandom& random) const {
  for (;;) {
    const FaceId f = draw_face(random, 0, faces_.size());
    // Uniform in the triangle, by Turk.
    const double root = std::sqrt(random.real()), along = random.real();
    const std::array<double, 3> bary{1 - root, root * (1 - along), root * along};
    if (*std::min_element(bary.begin(), bary.end()) > kBarycentricSnap) return make_surface_point(f, bary);
  }
}

}  // namespace gvd
