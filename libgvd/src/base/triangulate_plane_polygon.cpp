#include "base/triangulate_plane_polygon.hpp"

#include <algorithm>
#include <queue>

#include "base/box_tree.hpp"
#include "base/plane.hpp"

namespace gvd {
namespace {

/// Corners are on one line where twice their area is below this part of the square of the triangle's longest side:
/// far above the rounding of coordinates in [0, 1] that were made on one line. Dimensionless.
constexpr double kOnLine = 1e-12;

double longest_square(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

/// A triangle, its border and what is within rounding of it.
struct Reach {
  std::array<Vec2, 3> corners;
  double slack;

  Reach(const Vec2& a, const Vec2& b, const Vec2& c) : corners{a, b, c}, slack(-kOnLine * longest_square(a, b, c)) {}

  /// Whether a point of the box is on the inner side of each side of the triangle. Exact for a point. Never false of
  /// a box with such a point in it: the corner of the box that is tried lies farther inside, and rounding keeps order.
  bool meets(const Box2& box) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 &from = corners[i], &to = corners[(i + 1) % 3];
      const Vec2 inmost(to.y() > from.y() ? box.low.x() : box.high.x(), to.x() > from.x() ? box.high.y() : box.low.y());
      if (twice_signed_area(from, to, inmost) < slack) return false;
    }
    return true;
  }
};

/// Each corner waits in a queue with the shape that it would have as an ear. The best is tried; where another corner
/// lies in its triangle, it waits for that one to be cut off, since till then it can't be an ear. So the search for
/// what lies in a corner's triangle goes round the polygon once, however often it is interrupted, and a corner has a
/// new triangle only where a neighbour is cut off.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& corners) : corners_(corners), ring_(corners.size()) {
    boxes_.build(corners.size(), [&](std::size_t i) { return Box2{corners[i], corners[i]}; });
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) ring_[i] = {(i + n - 1) % n, (i + 1) % n};
    for (std::size_t i = 0; i < n; ++i) enqueue(i);
  }

  std::vector<std::array<std::size_t, 3>> run() {
    std::vector<std::array<std::size_t, 3>> triangles;
    for (std::size_t left = corners_.size(); left > 3; --left) {
      const std::size_t ear = take_ear();
      triangles.push_back(around(ear));
      cut_off(ear);
    }
    if (corners_.size() >= 3) triangles.push_back(around(ring_[first_left()].after));
    return triangles;
  }

 private:
  static constexpr std::size_t kNone = BoxTree::kNone;

  struct Place {
    std::size_t before;
    std::size_t after;
    bool is_left = true;
    int version = 0;              ///< of its triangle
    std::size_t searched = 0;     ///< no corner before this one lies in its triangle
    std::size_t waiting = kNone;  ///< the first in the list of those that wait for this corner to be cut off
  };

  struct Candidate {
    double shape;
    std::size_t corner;
    int version;
    bool operator<(const Candidate& other) const {
      return shape != other.shape ? shape < other.shape : corner > other.corner;
    }
  };

  struct Waiting {
    Candidate candidate;
    std::size_t next;
  };

  std::array<std::size_t, 3> around(std::size_t i) const { return {ring_[i].before, i, ring_[i].after}; }
  std::size_t first_left() const {
    const auto found = std::find_if(ring_.begin(), ring_.end(), [](const Place& place) { return place.is_left; });
    return static_cast<std::size_t>(found - ring_.begin());
  }
  double twice_area_at(std::size_t i) const {
    return twice_signed_area(corners_[ring_[i].before], corners_[i], corners_[ring_[i].after]);
  }

  /// As an ear: twice the area over the square of the longest side, which is positive.
  void enqueue(std::size_t i) {
    const double area = twice_area_at(i);
    const double longest = longest_square(corners_[ring_[i].before], corners_[i], corners_[ring_[i].after]);
    if (area > kOnLine * longest) {
      queue_.push({area / longest, i, ring_[i].version});
    } else {
      enqueue_last(i);
    }
  }

  /// As a corner that is no ear: it comes behind every ear, for the polygons that rounding has folded.
  void enqueue_last(std::size_t i) { queue_.push({twice_area_at(i) - 4, i, ring_[i].version}); }

  /// The ear that leaves the roundest triangle.
  std::size_t take_ear() {
    while (true) {
      const Candidate best = queue_.top();
      queue_.pop();
      Place& place = ring_[best.corner];
      if (!place.is_left || place.version != best.version) continue;
      if (best.shape < 0) return best.corner;
      place.searched = find_inside(best.corner, place.searched);
      if (place.searched == kNone) return best.corner;
      waiting_.push_back({best, ring_[place.searched].waiting});
      ring_[place.searched].waiting = waiting_.size() - 1;
      enqueue_last(best.corner);
    }
  }

  /// The first corner from `from` on in the triangle of corner i. One at the place of a corner of the triangle is the
  /// same point met again, where the polygon touches itself, and does no harm.
  std::size_t find_inside(std::size_t i, std::size_t from) const {
    const auto own = around(i);
    const Reach triangle(corners_[own[0]], corners_[own[1]], corners_[own[2]]);
    const auto meets = [&triangle](const Box2& box) { return triangle.meets(box); };
    const auto is_corner = [&](std::size_t k) {
      return std::any_of(own.begin(), own.end(), [&](std::size_t o) { return corners_[k] == corners_[o]; });
    };
    std::size_t found = boxes_.find(from, meets);
    while (found != kNone && is_corner(found)) found = boxes_.find(found + 1, meets);
    return found;
  }

  void cut_off(std::size_t ear) {
    const auto [before, after] = std::pair(ring_[ear].before, ring_[ear].after);
    ring_[ear].is_left = false;
    boxes_.remove(ear);
    ring_[before].after = after;
    ring_[after].before = before;
    for (const std::size_t i : {before, after}) {
      ++ring_[i].version;
      ring_[i].searched = 0;
      enqueue(i);
    }
    for (std::size_t i = ring_[ear].waiting; i != kNone; i = waiting_[i].next) queue_.push(waiting_[i].candidate);
  }

  const std::vector<Vec2>& corners_;
  std::vector<Place> ring_;
  BoxTree boxes_;  ///< of the corners that are left
  std::vector<Waiting> waiting_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate_plane_polygon(const std::vector<Vec2>& corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  return EarClipper(corners).run();
}

}  // namespace gvd
