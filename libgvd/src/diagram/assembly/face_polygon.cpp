// Polygons in a face, and the label intervals round them.
//
// All tests use barycentric coordinates, which an affine map takes to the plane. This keeps convexity and the order of
// points, for a needle as well as for a regular triangle. A shortest path stays in its cell. Therefore the interval
// through which it enters the face and the interval that it reaches belong to one piece, and the two sides of a piece
// that crosses the polygon can be assembled separately.
// Source: not in the paper, which leaves open how a face with many crossings is closed (section 4.3).
#include "diagram/assembly/face_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace gvd {
namespace {

/// A path that enters within this distance of a crossing, as a fraction of the edge, may belong to the cell on either
/// side of the crossing.
constexpr double kNearCrossing = 1e-9;

/// Whether a, b, c are counter-clockwise; c may lie up to `inversion` on the wrong side.
bool turns_left(const Bary& a, const Bary& b, const Bary& c, double inversion) {
  const double area = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
  return area >= 0 || area >= -inversion * std::max({bary_distance(a, b), bary_distance(b, c), bary_distance(c, a)});
}

}  // namespace

Bary midpoint(const FacePolygon& polygon, std::size_t i) {
  return mix(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, 0.5);
}

Bary centre(const FacePolygon& polygon) {
  Bary sum{0, 0, 0};
  for (const PolygonCorner& c : polygon) {
    for (int k = 0; k < 3; ++k) sum[k] += c.bary[k] / static_cast<double>(polygon.size());
  }
  return sum;
}

bool is_convex(const std::vector<Bary>& polygon, double inversion) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], inversion)) return false;
  }
  return true;
}

bool is_inside(const FacePolygon& polygon, const Bary& p, double inversion) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i].bary, polygon[(i + 1) % n].bary, p, inversion)) return false;
  }
  return *std::min_element(p.begin(), p.end()) >= 0;
}

double bary_distance(const Bary& p, const Bary& q) { return std::hypot(q[1] - p[1], q[2] - p[2]); }

void LabelIntervals::unite_by_paths(const FacePaths& paths) {
  for (int i = 0; i < std::ssize(boundary_); ++i) {
    const auto entry = paths.entry(boundary_[i].next, middle_of_interval(i));
    if (!entry) return;
    const int entered = interval_at(*entry);
    if (boundary_[entered].next == boundary_[i].next) unite(entered, i);
  }
}

/// The interval that contains a position on the boundary, counted as corner + t.
int LabelIntervals::interval_at(double position) const {
  const auto after = std::upper_bound(boundary_.begin(), boundary_.end(), position,
                                      [](double p, const BoundaryCrossing& c) { return p < c.corner + c.t; });
  const auto first = after == boundary_.begin() ? boundary_.end() : after;
  return static_cast<int>(first - boundary_.begin()) - 1;
}

/// The point halfway along interval i on the boundary.
Bary LabelIntervals::middle_of_interval(int i) const {
  const double begin = position(i), end = position((i + 1) % static_cast<int>(boundary_.size()));
  const double half = 0.5 * (begin + end + (end > begin ? 0 : 3));
  const double middle = half < 3 ? half : half - 3;
  const int corner = std::min(static_cast<int>(middle), 2);
  return bary_on_side(corner, middle - corner);
}

bool LabelIntervals::path_enters_through(int interval, const Bary& p, const FacePaths& paths) {
  const auto entry = paths.entry(boundary_[interval].next, p);
  if (!entry) return false;
  const int n = static_cast<int>(boundary_.size()), entered = interval_at(*entry);
  if (are_one_piece(entered, interval)) return true;
  const auto is_near = [&](int crossing) {
    const double distance = std::abs(*entry - position(crossing));
    return std::min(distance, 3 - distance) <= std::max(kNearCrossing, paths.crossing_error(boundary_[crossing]));
  };
  // Look beyond crossings that are within rounding of the entry, in both directions.
  for (int i = entered; is_near(i); i = (i + n - 1) % n) {
    if (are_one_piece((i + n - 1) % n, interval)) return true;
    if (i == (entered + 1) % n) break;
  }
  for (int i = (entered + 1) % n; is_near(i); i = (i + 1) % n) {
    if (are_one_piece(i, interval)) return true;
    if (i == entered) break;
  }
  return false;
}

// Pieces do not cross, so the smaller polygons are nested, and one pass over the corners cuts each off when its second
// interval comes, inner polygons first.
std::vector<FacePolygon> split_at_united_intervals(const FacePolygon& polygon, LabelIntervals& intervals) {
  std::vector<FacePolygon> polygons;
  FacePolygon rest;
  std::map<int, std::vector<std::size_t>> found;  // piece -> indices of its intervals in `rest`, ascending
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t last = rest.size();
    auto& own = found[intervals.piece(polygon[k].interval)];
    // Drop intervals that have been cut off from `rest` with a smaller polygon.
    while (!own.empty() &&
           (own.back() >= last || !intervals.are_one_piece(rest[own.back()].interval, polygon[k].interval)))
      own.pop_back();
    rest.push_back(polygon[k]);
    const bool closes_round = !own.empty() && own.back() == 0 && k + 1 == polygon.size();
    if (own.empty() || own.back() + 1 == last || closes_round) {
      own.push_back(last);
      continue;
    }
    const auto begin = rest.begin() + own.back() + 1;
    polygons.emplace_back(begin, rest.end());
    rest.erase(begin, rest.end());
  }
  if (!polygons.empty()) polygons.push_back(std::move(rest));
  return polygons;
}

}  // namespace gvd
