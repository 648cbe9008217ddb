// Ear clipping for simple polygons in the plane: cuts off the best ear until a single triangle remains.
//
// Source: G. H. Meisters, Polygons have ears, 1975. Each corner waits in a queue with the quality that it would have as
// an ear, and the best one is tried first. If another corner lies in its triangle, the corner can't be an ear before
// that other corner is cut off, and waits for that. Its search for corners in its triangle then continues where it
// stopped, so that it visits every other corner once, however often it is interrupted. It starts over only when a
// neighbour is cut off.
// Invariant: a corner whose triangle has no area is queued behind every ear, so that the loop ends even for folded
// polygons.
#include "base/ear_clipping.hpp"

#include <algorithm>
#include <queue>

#include "base/box_tree.hpp"
#include "base/plane.hpp"

namespace gvd {
namespace {

using CornerTriple = std::array<std::size_t, 3>;

/// Three corners count as collinear if twice their signed area is below this fraction of the square of the triangle's
/// longest side. That is far above the rounding error of collinear points with coordinates in [0, 1]. Dimensionless.
constexpr double kCollinear = 1e-12;

double longest_square(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

/// A triangle with its border and all points within rounding of it.
struct ThickTriangle {
  std::array<Vec2, 3> corners;
  double slack;  // < 0

  ThickTriangle(const Vec2& a, const Vec2& b, const Vec2& c)
      : corners{a, b, c}, slack(-kCollinear * longest_square(a, b, c)) {}

  /// Whether the box has, for each side of the triangle, a point on the inner side of it. The answer is exact for a box
  /// of one point, and never false for a box that contains a point of the triangle: the tested corner of the box lies
  /// at least as far inside, and rounding preserves the order.
  bool may_contain(const Box2& box) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 &from = corners[i], &to = corners[(i + 1) % 3];
      const Vec2 inmost((to.y() > from.y() ? box.min() : box.max()).x(),
                        (to.x() > from.x() ? box.max() : box.min()).y());
      if (twice_signed_area(from, to, inmost) < slack) return false;
    }
    return true;
  }
};

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& corners)
      : corners_(corners), ring_(corners.size()), searches_(corners.size()) {
    boxes_.build(corners.size(), [&](std::size_t i) { return Box2(corners[i]); });
    for (std::size_t i = 0; i < corners.size(); ++i) enqueue(i);
  }

  std::vector<CornerTriple> run() {
    std::vector<CornerTriple> triangles;
    while (ring_.left_count() > 3) {
      const std::size_t ear = take_ear();
      triangles.push_back(ring_.triangle(ear));
      cut_off(ear);
    }
    if (ring_.left_count() == 3) triangles.push_back(ring_.triangle(ring_.after(ring_.first_left())));
    return triangles;
  }

 private:
  static constexpr std::size_t kNone = BoxTree::kNone;

  struct Search {
    std::size_t searched = 0;     ///< no corner before this one lies in the corner's triangle
    std::size_t waiting = kNone;  ///< head of the list of corners that wait for this one to be cut off
  };

  struct Waiting {
    EarCandidate candidate;
    std::size_t next;
  };

  double twice_area_at(std::size_t i) const {
    return twice_signed_area(corners_[ring_.before(i)], corners_[i], corners_[ring_.after(i)]);
  }

  /// Queues corner i as an ear. Its quality, twice the area over the square of the longest side, is positive.
  void enqueue(std::size_t i) {
    const double area = twice_area_at(i);
    const double longest = longest_square(corners_[ring_.before(i)], corners_[i], corners_[ring_.after(i)]);
    if (area > kCollinear * longest) {
      queue_.push(ring_.candidate(i, area / longest));
    } else {
      enqueue_last(i);
    }
  }

  /// Queues corner i, which is not an ear, behind every ear. It is taken from there only if rounding has folded the
  /// polygon.
  void enqueue_last(std::size_t i) { queue_.push(ring_.candidate(i, twice_area_at(i) - 4)); }

  /// Takes the ear with the roundest triangle from the queue or, if no ear is left, the corner with the largest signed
  /// area.
  std::size_t take_ear() {
    while (true) {
      const EarCandidate best = queue_.top();
      queue_.pop();
      if (!ring_.is_current(best)) continue;
      if (best.quality < 0) return best.corner;
      std::size_t& searched = searches_[best.corner].searched;
      searched = find_inside(best.corner, searched);
      if (searched == kNone) return best.corner;
      waiting_.push_back({best, searches_[searched].waiting});
      searches_[searched].waiting = waiting_.size() - 1;
      enqueue_last(best.corner);
    }
  }

  /// Returns the first corner, from `from` on, that lies in the triangle of corner i. A corner at the position of one
  /// of the triangle's own corners does not count: there the polygon touches itself.
  std::size_t find_inside(std::size_t i, std::size_t from) const {
    const CornerTriple own = ring_.triangle(i);
    const ThickTriangle triangle(corners_[own[0]], corners_[own[1]], corners_[own[2]]);
    const auto may_contain = [&triangle](const Box2& box) { return triangle.may_contain(box); };
    const auto is_corner = [&](std::size_t k) {
      return std::any_of(own.begin(), own.end(), [&](std::size_t o) { return corners_[k] == corners_[o]; });
    };
    std::size_t found = boxes_.find(from, may_contain);
    while (found != kNone && is_corner(found)) found = boxes_.find(found + 1, may_contain);
    return found;
  }

  void cut_off(std::size_t ear) {
    boxes_.remove(ear);
    ring_.remove(ear);
    for (const std::size_t i : {ring_.before(ear), ring_.after(ear)}) {
      searches_[i].searched = 0;
      enqueue(i);
    }
    for (std::size_t i = searches_[ear].waiting; i != kNone; i = waiting_[i].next) queue_.push(waiting_[i].candidate);
  }

  const std::vector<Vec2>& corners_;
  PolygonRing ring_;
  std::vector<Search> searches_;  ///< per corner
  BoxTree boxes_;                 ///< holds the remaining corners
  std::vector<Waiting> waiting_;
  std::priority_queue<EarCandidate> queue_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate_plane_polygon(const std::vector<Vec2>& corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  return EarClipper(corners).run();
}

}  // namespace gvd
