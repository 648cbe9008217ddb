#include "diagram/assembly/branch_placement.hpp"

#include <algorithm>
#include <vector>

#include "base/find_root.hpp"
#include "diagram/assembly/face_distances.hpp"

namespace gvd {
namespace {

/// Least barycentric coordinate of a guessed branch point: ten times the gap between crossings and corners. It moves
/// the point by at most a millionth of the triangle's height.
constexpr double kInside = 1e-6;

/// The same for accurate guesses, which lie on a side or at a vertex by a tie: they move by rounding only. A little
/// less than the coordinate of confirmed points, so that these do not move at all.
constexpr double kInsideExactly = 1.2e-12;
static_assert(kInsideExactly < kInsideFace);

/// Number of halvings of the way to a point that is not valid: to the last digits of a coordinate.
constexpr int kHalvings = 45;

/// The last part of the valid way is left out, relative to its length: at its end three points are collinear, and an
/// arc would touch the end of another one. A point up to kByTie beyond the end, in barycentric coordinates, is invalid
/// by rounding and stays as near as kShort. A point farther beyond is a bad guess, which needs no accuracy.
constexpr double kShort = 1e-12, kShortOfGuess = 0.125, kByTie = 1e-9;

/// The point nearest to `wanted` on the way from `safe` that `is_valid` accepts.
template <class IsValid>
Bary approach(const Bary& safe, const std::optional<Bary>& wanted, IsValid is_valid) {
  if (!wanted) return safe;
  if (is_valid(*wanted)) return *wanted;
  const double last = find_last(kHalvings, [&](double t) { return is_valid(mix(safe, *wanted, t)); });
  const double beyond = (1 - last) * bary_distance(safe, *wanted);
  return mix(safe, *wanted, last * (1 - (beyond > kByTie ? kShortOfGuess : kShort)));
}

}  // namespace

Bary BranchPlacement::place_in_face(const FacePolygon& polygon, const std::optional<Bary>& wanted) const {
  const double least = is_accurate_ ? kInsideExactly : kInside;
  return approach(centre(polygon), wanted,
                  [&](const Bary& p) { return *std::min_element(p.begin(), p.end()) >= least; });
}

Bary BranchPlacement::place_in_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted) const {
  return approach(centre(polygon), wanted, [&](const Bary& p) { return is_inside(polygon, p, inversion()); });
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
  return approach(centre(around), wanted, is_valid);
}

}  // namespace gvd
