// Decides in which direction generators at vertices move, and where they come to rest.
//
// At a vertex the energy has no gradient, because the directions of all paths that bend at a vertex with curvature jump
// as the generator passes the vertex. If a saddle is a minimum, no gradient vanishes there. Steps along gradients would
// jump from one side to the other for ever, and the changes of the gradient would mislead a quasi-Newton method. So
// generators at vertices follow the slopes of the energy there (VertexSlope), and rest if it falls in no direction.
// Slopes are computed from prefix sums of unit vectors over sorted directions: the sum over any interval of directions
// is the difference of two prefix sums.
#include "vertex_rests.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/geodesic_tracing.hpp"

namespace gvd {
namespace {

using std::numbers::pi;

/// Number of directions in which the slope is evaluated first. No two of its minima are closer to each other than the
/// angle of a face.
constexpr int kDirections = 64;

/// Number of steps of the golden-section search that follows. It ends with 1e-7 of the distance between two directions.
constexpr int kSearchSteps = 34;

/// Paths within this angle of the direction to a vertex count as bending there, radians. It is several times the
/// rounding of departures (1e-7) and of samples (2e-7).
constexpr double kSameDirection = 1e-6;

/// If the excess of a saddle's total angle is less than this, in radians, its slopes differ too little to hold a
/// generator.
constexpr double kLeastExcess = 1e-6;

/// Number of paths that stand for all paths that bend at the vertex. They are spread evenly over the excess of its
/// angle.
constexpr int kBentPaths = 32;

/// Generators whose step ends before a vertex also go to the vertex if it is within this fraction of the reach, because
/// otherwise the next steps would bring them there.
constexpr double kClose = 0.1;

bool is_inner_saddle(const TangentFan& fan) {
  return fan.closed() && fan.total() / fan.scale() > 2 * pi + kLeastExcess;
}

/// The tangent direction from the generator to a corner of its face, along the straight line in the face.
double direction_to(const Mesh& mesh, const SurfacePoint& generator, int corner) {
  const TangentFan fan(mesh, generator);
  const FaceLayout layout(mesh, generator.face);
  return fan.angle(generator.face, layout.corner[corner] - layout.at(generator.bary));
}

/// Whether the energy would rise in all directions at a saddle, judged by the paths of a generator beside it that sees
/// the saddle in the direction `ahead`. Angles at the saddle are measured from the direction back to the generator.
bool would_rest(double total, double ahead, std::span<const PathSample> paths) {
  const double excess = total - 2 * pi;
  std::vector<DepartingPath> from_vertex;
  double bent = 0;
  for (const PathSample& path : paths) {
    const double turn = std::remainder(path.angle - ahead, 2 * pi);
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

VertexSlope::VertexSlope(double total, bool is_closed, std::vector<DepartingPath> paths)
    : total_(total), is_closed_(is_closed) {
  std::stable_sort(paths.begin(), paths.end(),
                   [](const DepartingPath& a, const DepartingPath& b) { return a.angle < b.angle; });
  sums_.push_back({});
  for (const DepartingPath& path : paths) {
    angles_.push_back(path.angle);
    sums_.push_back({sums_.back().vector + path.weight * unit_vector(path.angle), sums_.back().weight + path.weight});
  }
}

VertexSlope::Sum VertexSlope::between(double begin, double end) const {
  const auto index = [&](double angle) {
    return static_cast<std::size_t>(std::lower_bound(angles_.begin(), angles_.end(), angle) - angles_.begin());
  };
  const Sum &first = sums_[index(begin)], &last = sums_[std::max(index(begin), index(end))];
  return {last.vector - first.vector, last.weight - first.weight};
}

double VertexSlope::at(double angle) const {
  const double reach = is_closed_ ? std::min(pi, 0.5 * total_) : pi;
  double straight = 0, weight = 0;
  for (int turn = is_closed_ ? -1 : 0; turn <= (is_closed_ ? 1 : 0); ++turn) {
    // A path at angle a is also at a + turn * total.
    const double shift = turn * total_;
    const Sum sum = between(angle - reach - shift, angle + reach - shift);
    straight += sum.vector.dot(unit_vector(angle - shift));
    weight += sum.weight;
  }
  const double bent = sums_.back().weight - weight;
  return -2 * (straight - bent);
}

VertexSlope::Least VertexSlope::least() const {
  const double step = total_ / kDirections;
  double best = 0, least = at(0);
  for (int k = 1; k <= kDirections; ++k) {
    const double slope = at(k * step);
    if (slope < least) std::tie(best, least) = std::pair(k * step, slope);
  }
  double begin = best - step, end = best + step;
  if (!is_closed_) std::tie(begin, end) = std::pair(std::max(0.0, begin), std::min(total_, end));
  constexpr double kGolden = 2 - std::numbers::phi;
  for (int k = 0; k < kSearchSteps; ++k) {
    const double p = begin + kGolden * (end - begin), q = end - kGolden * (end - begin);
    (at(p) < at(q) ? end : begin) = at(p) < at(q) ? q : p;
  }
  const double middle = 0.5 * (begin + end), slope = at(middle);
  return slope < least ? Least{middle, slope} : Least{best, least};
}

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
  std::vector<DepartingPath> from_vertex;
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
