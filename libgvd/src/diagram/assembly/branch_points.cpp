// Finds where a branch point lies in a polygon of a face.
//
// A branch point that the paths confirm is used as it is: three shortest paths of equal length reach it through the
// intervals in question, and no other generator is nearer. If there is none, Newton's method or a linear system gives a
// guess, which is moved to where the arcs that end there can't cross the rest of the face. Closing a face therefore
// never depends on a number.
// Source: not in the paper, which leaves open how a face with many crossings is closed (section 4.3).
#include "diagram/assembly/branch_points.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "base/roots.hpp"

namespace gvd {
namespace {

/// Interval i of a polygon and the intervals before and after it, each given by the corner at which it begins.
struct Neighbours {
  const PolygonCorner &before, &own, &after;
  Neighbours(const FacePolygon& polygon, std::size_t i)
      : before(polygon[(i + polygon.size() - 1) % polygon.size()]),
        own(polygon[i]),
        after(polygon[(i + 1) % polygon.size()]) {}
  bool differ() const { return before.next != after.next; }
};

bool is_in_face(const std::optional<Bary>& p) { return p && *std::min_element(p->begin(), p->end()) > -kBeyondFace; }

/// Least barycentric coordinate of a guessed branch point: ten times the gap between crossings and corners. It moves
/// the point by at most a millionth of the triangle's height.
constexpr double kInsideOfGuess = 1e-6;

/// The same for accurate guesses, which may lie on a side or at a vertex because of a tie. These only move by rounding.
/// The value is a little less than the coordinate of confirmed points, so that confirmed points don't move at all.
constexpr double kInsideExactly = 1.2e-12;
static_assert(kInsideExactly < kInsideFace);

/// Number of halvings of the way to a point that is not valid. They determine a coordinate to its last digits.
constexpr int kHalvings = 45;

/// The last part of the valid way is left out, because at its end three points are collinear, and an arc would touch
/// the end of another arc. The values are relative to the length of the way. A point up to kByTie beyond the end, in
/// barycentric coordinates, is invalid by rounding, and is moved to kShort before the end. An accurate guess farther
/// beyond the end comes from a tie or from rounding in a thin face, and is moved as far before the end as it was beyond
/// it. Any other point beyond the end is a bad guess, which needs no accuracy.
constexpr double kShort = 1e-12, kShortOfGuess = 0.125, kByTie = 1e-9;

/// The part of the valid way that is left out if the wanted point lies `beyond` its end, in barycentric coordinates.
double left_out(double beyond, bool is_accurate) {
  if (beyond <= kByTie) return kShort;
  return is_accurate ? std::min(beyond, kShortOfGuess) : kShortOfGuess;
}

/// The point nearest to `wanted`, on the way from `safe` to it, that `is_valid` accepts.
template <class IsValid>
Bary approach(const Bary& safe, const std::optional<Bary>& wanted, bool is_accurate, IsValid is_valid) {
  if (!wanted) return safe;
  if (is_valid(*wanted)) return *wanted;
  const double last = find_last(kHalvings, [&](double t) { return is_valid(mix(safe, *wanted, t)); });
  const double beyond = (1 - last) * bary_distance(safe, *wanted);
  return mix(safe, *wanted, last * (1 - left_out(beyond, is_accurate)));
}

/// After a first branch point, the rest of a polygon may be much thinner than it is long. By rounding or a tie, an
/// accurate guess may lie beside the polygon, up to this far in barycentric coordinates. It is then moved to the
/// nearest point of the polygon, and not to where the way from the centre leaves the polygon.
constexpr double kBesidePolygon = 1e-4;

Bary nearest_of_segment(const Bary& a, const Bary& b, const Bary& p) {
  const Vec2 from = affine_point(a), along = affine_point(b) - from;
  return mix(a, b, nearest_on_segment(from, along, affine_point(p)));
}

/// The guess or, if it is just beside the polygon, the nearest point of the polygon.
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

double inversion_of(bool is_accurate) { return is_accurate ? kTieInversion : 0; }

}  // namespace

std::optional<BranchSearch::Confirmed> BranchSearch::find_confirmed(const FacePolygon& polygon) {
  if (paths_ == nullptr) return std::nullopt;
  const Bary inside = centre(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!is_first_search(polygon, i, Search::from_nearby)) continue;
    if (const auto p = confirmed_point(polygon, i, mix(midpoint(polygon, i), inside, 0.5))) return Confirmed{i, *p};
  }
  // The search stagnates at ridges of the distances, so it is repeated from every candidate.
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Neighbours near(polygon, i);
    if (!near.differ() || !is_first_search(polygon, i, Search::everywhere)) continue;
    for (const Bary& start : paths_->equidistant_points(near.before.next, near.own.next, near.after.next)) {
      if (const auto p = confirmed_point(polygon, i, start)) return Confirmed{i, *p};
    }
  }
  return std::nullopt;
}

/// Whether this search for interval i and its neighbours has not been made yet; records that it is made now. Most
/// intervals keep their neighbours when another one is closed. Without the record, hundreds of generators in one face
/// would take minutes.
bool BranchSearch::is_first_search(const FacePolygon& polygon, std::size_t i, Search search) {
  const Neighbours near(polygon, i);
  return failed_.insert({search, near.before.interval, near.own.interval, near.after.interval}).second;
}

/// Searches a confirmed branch point of interval i and its neighbours from `start`.
std::optional<Bary> BranchSearch::confirmed_point(const FacePolygon& polygon, std::size_t i, const Bary& start) {
  const Neighbours near(polygon, i);
  if (!near.differ()) return std::nullopt;
  const auto p = distances_.equidistant(near.before.next, near.own.next, near.after.next, start);
  if (!p || !paths_->is_branch_point(near.before.next, near.own.next, near.after.next, *p)) return std::nullopt;
  for (const PolygonCorner* corner : {&near.before, &near.own, &near.after}) {
    if (!intervals_.path_enters_through(corner->interval, *p, *paths_)) return std::nullopt;
  }
  return p;
}

/// If the distances are accurate and the first search ends outside the face, further searches start at the corners of
/// the polygon and of the face, because a tie puts the point there: at a vertex, or on an edge that is a bisector.
std::optional<Bary> BranchSearch::guess(const FacePolygon& polygon, std::size_t i, const Bary& start) const {
  const Neighbours near(polygon, i);
  const auto search = [&](const Bary& from) {
    return distances_.equidistant(near.before.next, near.own.next, near.after.next, from);
  };
  const auto first = search(start);
  if (paths_ == nullptr || is_in_face(first)) return first;
  std::vector<Bary> starts{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const PolygonCorner& corner : polygon) starts.push_back(corner.bary);
  for (const Bary& other : starts) {
    const auto p = search(other);
    if (is_in_face(p)) return p;
  }
  return first;
}

double BranchSearch::clearance(const FacePolygon& polygon, std::size_t i) const {
  const Neighbours near(polygon, i);
  const auto p = guess(polygon, i, midpoint(polygon, i));
  if (!is_in_face(p)) return -std::numeric_limits<double>::max();
  const double own = distances_.at(near.own.next, *p);
  double least = kInfinity;
  for (const PolygonCorner& c : polygon) {
    if (c.next == near.before.next || c.next == near.own.next || c.next == near.after.next) continue;
    least = std::min(least, distances_.at(c.next, *p) - own);
  }
  return least;
}

Bary place_in_face(const FacePolygon& polygon, const std::optional<Bary>& wanted, bool is_accurate) {
  const double least = is_accurate ? kInsideExactly : kInsideOfGuess;
  return approach(centre(polygon), wanted, is_accurate,
                  [&](const Bary& p) { return *std::min_element(p.begin(), p.end()) >= least; });
}

Bary place_in_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted, bool is_accurate) {
  return approach(centre(polygon), is_accurate ? moved_to_polygon(polygon, wanted) : wanted, is_accurate,
                  [&](const Bary& p) { return is_inside(polygon, p, inversion_of(is_accurate)); });
}

Bary place_at_interval(const FacePolygon& polygon, std::size_t i, const std::optional<Bary>& wanted, bool is_accurate) {
  const double inversion = inversion_of(is_accurate);
  const std::size_t n = polygon.size();
  std::vector<Bary> rest{Bary{}};  // the branch point, then the remaining corners
  for (std::size_t k = 2; k < n; ++k) rest.push_back(polygon[(i + k) % n].bary);
  const auto is_valid = [&](const Bary& p) {
    rest[0] = p;
    return is_convex(rest, inversion) && is_inside(polygon, p, inversion);
  };
  // Every point of the quadrilateral of the interval's two corners and their neighbours is valid, so its centre is
  // valid.
  const FacePolygon around{polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]};
  return approach(centre(around), wanted, is_accurate, is_valid);
}

}  // namespace gvd
