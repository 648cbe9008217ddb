#include "state/vertex_rests.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "integrals/vertex_slope.hpp"

namespace gvd {
namespace {

/// Paths whose direction is within this angle of that to a vertex bend there, radians: ten times
/// what the rounding of departures (1e-7) and of samples (2e-7) makes.
constexpr double kSameDirection = 1e-6;

/// Where the total angle is larger by less than this, the slopes of a saddle differ too little to hold a generator,
/// radians.
constexpr double kLeastExcess = 1e-6;

/// Number of paths for all those that bend at the vertex: they spread evenly over the excess of its angle.
constexpr int kBentPaths = 32;

/// Generators that end their way before a vertex go there too if it is within this fraction of the reach: else, the
/// next steps would bring them there.
constexpr double kClose = 0.1;

bool is_inner_saddle(const TangentFan& fan) {
  return fan.closed() && fan.total() / fan.scale() > 2 * std::numbers::pi + kLeastExcess;
}

/// The tangent direction from the generator to a corner of its face, by the straight line in the face.
double direction_to(const Mesh& mesh, const SurfacePoint& generator, int corner) {
  const TangentFan fan(mesh, generator);
  const FaceLayout layout(mesh, generator.face);
  Bary at{0, 0, 0};
  at[corner] = 1;
  return fan.angle(generator.face, layout.at(at) - layout.at(generator.bary));
}

/// Whether the energy would rise in all directions at a saddle, by the paths of a generator beside it that sees it in
/// the direction `ahead`. Angles at the saddle begin at the direction back to the generator.
bool would_rest(double total, double ahead, std::span<const PathSample> paths) {
  const double excess = total - 2 * std::numbers::pi;
  std::vector<VertexPath> from_vertex;
  double bent = 0;
  for (const PathSample& path : paths) {
    const double turn = std::remainder(path.angle - ahead, 2 * std::numbers::pi);
    if (std::abs(turn) < kSameDirection) {
      bent += path.weight;
      continue;
    }
    const double angle = 0.5 * total + turn + std::copysign(0.5 * excess, turn);
    from_vertex.push_back({std::clamp(angle, 0.0, std::nextafter(total, 0.0)), path.weight});
  }
  for (int k = 0; k < kBentPaths; ++k) {
    from_vertex.push_back({0.5 * total + ((k + 0.5) / kBentPaths - 0.5) * excess, bent / kBentPaths});
  }
  return VertexSlope(total, true, std::move(from_vertex)).least().slope >= 0;
}

}  // namespace

WatchedGenerators watch_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double reach) {
  const auto is_near_saddle = [&](const SurfacePoint& generator) {
    const Vec3 at = position(mesh, generator);
    return std::any_of(mesh.vertices(generator.face).begin(), mesh.vertices(generator.face).end(), [&](VertexId v) {
      return (mesh.position(v) - at).norm() <= reach && is_inner_saddle(TangentFan(mesh, vertex_point(mesh, v)));
    });
  };
  WatchedGenerators watched;
  for (const SurfacePoint& generator : generators) {
    watched.push_back(generator.kind() == SurfacePoint::Kind::vertex || is_near_saddle(generator));
  }
  return watched;
}

Vec2 steepest_way(const Mesh& mesh, const SurfacePoint& vertex, std::span<const PathSample> paths, double mass,
                  const Vec2& mean) {
  const TangentFan fan(mesh, vertex);
  if (fan.closed() && std::abs(fan.scale() - 1) < kLeastExcess) return mean;
  std::vector<VertexPath> from_vertex;
  for (const PathSample& path : paths) {
    from_vertex.push_back({std::min(normalized_angle(path.angle), fan.total()) / fan.scale(), path.weight});
  }
  const VertexSlope::Least least = VertexSlope(fan.total() / fan.scale(), fan.closed(), std::move(from_vertex)).least();
  return least.slope < 0 && mass > 0 ? Vec2(-least.slope / (2 * mass) * unit_vector(least.angle * fan.scale()))
                                     : Vec2::Zero();
}

std::optional<VertexId> find_rest(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way, double reach,
                                  std::span<const PathSample> paths) {
  if (generator.kind() == SurfacePoint::Kind::vertex || !(way.norm() > 0)) return std::nullopt;
  const Vec3 from = position(mesh, generator);
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh.vertices(generator.face)[i];
    if ((mesh.position(v) - from).norm() > std::clamp(way.norm(), kClose * reach, reach)) continue;
    const TangentFan fan(mesh, vertex_point(mesh, v));
    if (!is_inner_saddle(fan)) continue;
    const double ahead = direction_to(mesh, generator, i);
    if (std::cos(angle_of(way) - ahead) <= 0) continue;
    if (would_rest(fan.total() / fan.scale(), ahead, paths)) return v;
  }
  return std::nullopt;
}

}  // namespace gvd
