// Moves points and densities between a mesh and its decimated copy.
//
// The vertices of the copy are vertices of both meshes. A point moves to the closest point in the faces that are near
// these vertices and connected with them. A search through space could not distinguish two sheets of a thin body.
#include "copy_points.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "gvd/closest_point.hpp"
#include "mesh/find_coincident.hpp"

namespace gvd {
namespace {

constexpr std::string_view kSamplingStep = "sampling";

/// The point closest to `query` in the faces that are connected with the vertices within twice the distance of `query`
/// from the nearest vertex.
SurfacePoint find_closest(const Mesh& mesh, std::span<const VertexId> vertices, const Vec3& query) {
  const auto distance = [&](VertexId v) { return (mesh.position(v) - query).norm(); };
  const VertexId nearest = *std::ranges::min_element(vertices, {}, distance);
  ClosestPoint best{vertex_point(mesh, nearest), distance(nearest)};
  for (const FaceId f : faces_within(mesh, best.point, 2 * distance(nearest))) {
    const ClosestPoint found = closest_point_on_face(mesh, f, query);
    if (found.distance < best.distance) best = found;
  }
  return best.point;
}

/// Number of points between two reports of progress.
constexpr std::size_t kPointsPerReport = 64;

/// Calls move(point) for each point, one after the other, and returns the results.
template <class Move>
std::vector<SurfacePoint> move_points(const std::vector<SurfacePoint>& points, const Progress& progress,
                                      const StepPart& part, const Move& move) {
  std::vector<SurfacePoint> moved;
  for (const SurfacePoint& p : points) {
    if (moved.size() % kPointsPerReport == 0) {
      report_progress(progress, part, static_cast<double>(moved.size()) / static_cast<double>(points.size()));
    }
    moved.push_back(move(p));
  }
  return moved;
}

}  // namespace

bool are_apart(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  const std::vector<std::int32_t> first = find_coincident(mesh, points);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (static_cast<std::size_t>(first[i]) != i) return false;
  }
  return true;
}

SurfacePoint to_input(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point) {
  std::vector<VertexId> corners;
  for (const VertexId v : copy.mesh.vertices(point.face)) corners.push_back(copy.input_vertex[v]);
  return find_closest(input, corners, position(copy.mesh, point));
}

SurfacePoint to_copy(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point) {
  std::vector<VertexId> corners;
  for (const VertexId v : input.vertices(point.face)) corners.push_back(copy.copy_vertex[v]);
  return find_closest(copy.mesh, corners, position(input, point));
}

std::vector<SurfacePoint> to_input(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                   const Progress& progress, const StepPart& part) {
  return move_points(points, progress, part, [&](const SurfacePoint& p) { return to_input(input, copy, p); });
}

std::vector<SurfacePoint> to_copy(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                  const Progress& progress, const StepPart& part) {
  return move_points(points, progress, part, [&](const SurfacePoint& p) { return to_copy(input, copy, p); });
}

OrError<std::vector<SurfacePoint>> sample_on_copy(const Mesh& input, const CoarseCopy& copy,
                                                  const SamplingOptions& options) {
  auto sampled = try_to_sample_generators(copy.mesh, options);
  if (Error* const error = std::get_if<Error>(&sampled)) return std::move(*error);
  auto points =
      to_input(input, copy, std::get<std::vector<SurfacePoint>>(sampled), options.progress, {kSamplingStep, 1, 1});
  if (are_apart(input, points)) return points;
  return try_to_sample_generators(input, options);
}

Density to_copy(const Mesh& input, const CoarseCopy& copy, const Density& density) {
  if (density.is_uniform()) return {};
  IdVector<VertexId, double> mass(copy.mesh.vertex_count(), 0), area(copy.mesh.vertex_count(), 0);
  for (const FaceId f : input.faces()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = copy.copy_vertex[input.vertices(f)[i]];
      // If no face has an area, all corners have the same weight.
      const double weight = std::max(input.area(f), std::numeric_limits<double>::min());
      mass[v] += weight * density.corners[f][i];
      area[v] += weight;
    }
  }
  for (const VertexId v : copy.mesh.vertices()) mass[v] /= area[v];
  return make_vertex_density(copy.mesh, mass.raw());
}

}  // namespace gvd
