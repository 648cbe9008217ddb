// Ear clipping for simple polygons of the plane: the best ear is cut off until a triangle is left.
//
// Source: G. H. Meisters, Polygons have ears, 1975. Each corner waits in a queue with the quality that it would have as
// an ear, and the best one is tried first. Where another corner lies in its triangle, it waits until that one is cut
// off, because it can't be an ear before. So the search through a corner's triangle visits each other corner once,
// however often it is interrupted. It starts anew only where a neighbour is cut off.
// Invariant: a corner whose triangle has no area comes behind every ear, so the loop ends for folded polygons too.
#include "base/ear_clipping.hpp"

#include <algorithm>
#include <queue>

#include "base/box_tree.hpp"
#include "base/plane.hpp"

namespace gvd {
namespace {

using CornerTriple = std::array<std::size_t, 3>;

/// Three corners count as collinear where twice their signed area is below this fraction of the square of the
/// triangle's longest side: far above the rounding of collinear points with coordinates in [0, 1]. Dimensionless.
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

  /// Whether the box has a point on the inner side of each side of the triangle. Exact for a box of one point. Never
  /// false of a box that contains such a point: the corner of the box that is tested lies farther inside, and rounding
  /// keeps the order.
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
    std::size_t waiting = kNone;  ///< the first in the list of those that wait for this corner to be cut off
  };

  struct Waiting {
    EarCandidate candidate;
    std::size_t next;
  };

  double twice_area_at(std::size_t i) const {
    return twice_signed_area(corners_[ring_.before(i)], corners_[i], corners_[ring_.after(i)]);
  }

  /// Queues corner i as an ear. Its quality is twice the area over the square of the longest side, which is positive.
  void enqueue(std::size_t i) {
    const double area = twice_area_at(i);
    const double longest = longest_square(corners_[ring_.before(i)], corners_[i], corners_[ring_.after(i)]);
    if (area > kCollinear * longest) {
      queue_.push(ring_.candidate(i, area / longest));
    } else {
      enqueue_last(i);
    }
  }

  /// Queues corner i, which is no ear, behind every ear: for polygons that rounding has folded.
  void enqueue_last(std::size_t i) { queue_.push(ring_.candidate(i, twice_area_at(i) - 4)); }

  /// The ear that leaves the roundest triangle.
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

  /// The first corner from `from` on in the triangle of corner i. A corner at the position of one of the triangle's own
  /// is a point where the polygon touches itself, and does not count.
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
  BoxTree boxes_;                 ///< of the corners that are left
  std::vector<Waiting> waiting_;
  std::priority_queue<EarCandidate> queue_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate_plane_polygon(const std::vector<Vec2>& corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  return EarClipper(corners).run();
}

}  // namespace gvd
