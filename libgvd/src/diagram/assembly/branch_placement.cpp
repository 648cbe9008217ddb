#include "diagram/assembly/branch_placement.hpp"

#include <algorithm>
#include <vector>

#include "base/roots.hpp"
#include "diagram/assembly/face_distances.hpp"

namespace gvd {
namespace {

/// Least barycentric coordinate of a guessed branch point: ten times the gap between crossings and corners. It moves
/// the point by at most a millionth of the triangle's height.
constexpr double kInsideOfGuess = 1e-6;

/// The same for accurate guesses, which lie on a side or at a vertex by a tie: they move by rounding only. A little
/// less than the coordinate of confirmed points, so that these do not move at all.
constexpr double kInsideExactly = 1.2e-12;
static_assert(kInsideExactly < kInsideFace);

/// Number of halvings of the way to a point that is not valid: to the last digits of a coordinate.
constexpr int kHalvings = 45;

/// The last part of the valid way is left out, relative to its length: at its end three points are collinear, and an
/// arc would touch the end of another one. A point up to kByTie beyond the end, in barycentric coordinates, is invalid
/// by rounding and stays as near as kShort. An accurate guess farther beyond comes from a tie, or from rounding, in a
/// thin face: it stays as near as it was beyond. Otherwise a point farther beyond is a bad guess, which needs no
/// accuracy.
constexpr double kShort = 1e-12, kShortOfGuess = 0.125, kByTie = 1e-9;

/// The part of the valid way that is left out where the wanted point lies `beyond` its end, in barycentric coordinates.
double left_out(double beyond, bool is_accurate) {
  if (beyond <= kByTie) return kShort;
  return is_accurate ? std::min(beyond, kShortOfGuess) : kShortOfGuess;
}

/// The point nearest to `wanted` on the way from `safe` that `is_valid` accepts.
template <class IsValid>
Bary approach(const Bary& safe, const std::optional<Bary>& wanted, bool is_accurate, IsValid is_valid) {
  if (!wanted) return safe;
  if (is_valid(*wanted)) return *wanted;
  const double last = find_last(kHalvings, [&](double t) { return is_valid(mix(safe, *wanted, t)); });
  const double beyond = (1 - last) * bary_distance(safe, *wanted);
  return mix(safe, *wanted, last * (1 - left_out(beyond, is_accurate)));
}

/// A polygon that a first branch point has left may be much thinner than it is long. An accurate guess may lie beside
/// it by rounding or a tie: up to this far, in barycentric coordinates. It moves to the nearest point of the polygon,
/// and not to where the way from the centre leaves it.
constexpr double kBesidePolygon = 1e-4;

Bary nearest_of_segment(const Bary& a, const Bary& b, const Bary& p) {
  const Vec2 from = affine_point(a), along = affine_point(b) - from;
  const double length = along.squaredNorm();
  const double t = length > 0 ? (affine_point(p) - from).dot(along) / length : 0;
  return mix(a, b, std::clamp(t, 0.0, 1.0));
}

/// The guess or, where it is just beside the polygon, the nearest point of the polygon.
std::optional<Bary> moved_to_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted) {
  if (!wanted || is_inside(polygon, *wanted, 0)) return wanted;
  std::optional<Bary> nearest = wanted;
  double least = kBesidePolygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Bary p = nearest_of_segment(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, *wanted);
    const double distance = bary_distance(p, *wanted);
    if (distance >= least) continue;
    least = distance;
    nearest = p;
  }
  return nearest;
}

}  // namespace

Bary BranchPlacement::place_in_face(const FacePolygon& polygon, const std::optional<Bary>& wanted) const {
  const double least = is_accurate_ ? kInsideExactly : kInsideOfGuess;
  return approach(centre(polygon), wanted, is_accurate_,
                  [&](const Bary& p) { return *std::min_element(p.begin(), p.end()) >= least; });
}

Bary BranchPlacement::place_in_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted) const {
  return approach(centre(polygon), is_accurate_ ? moved_to_polygon(polygon, wanted) : wanted, is_accurate_,
                  [&](const Bary& p) { return is_inside(polygon, p, inversion()); });
}

Bary BranchPlacement::place_at_interval(const FacePolygon& polygon, std::size_t i,
                                        const std::optional<Bary>& wanted) const {
  const std::size_t n = polygon.size();
  std::vector<Bary> rest{Bary{}};  // the branch point, then the remaining corners
  for (std::size_t k = 2; k < n; ++k) rest.push_back(polygon[(i + k) % n].bary);
  const auto is_valid = [&](const Bary& p) {
    rest[0] = p;
    return is_convex(rest, inversion()) && is_inside(polygon, p, inversion());
  };
  // Every point of the quadrilateral of the interval's two corners and their neighbours is valid, so its centre is.
  const FacePolygon around{polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]};
  return approach(centre(around), wanted, is_accurate_, is_valid);
}

}  // namespace gvd
