#include "mesh/repair/triangulate_soup_polygon.hpp"

#include <algorithm>
#include <optional>
#include <queue>

#include "base/plane.hpp"
#include "base/polygon_ring.hpp"
#include "mesh/repair/project_polygon.hpp"

namespace gvd {
namespace {

class SoupEarClipper {
 public:
  SoupEarClipper(std::span<const std::int32_t> polygon, const ProjectedPolygon& projected, const EdgeQuery& is_edge)
      : polygon_(polygon),
        space_(projected.space),
        plane_(projected.plane),
        is_edge_(is_edge),
        ring_(projected.plane.size()) {
    for (std::size_t i = 0; i < ring_.corner_count(); ++i) {
      if (turn(i) <= kFlatSine) blockers_.push_back(i);
    }
    queue_all(kRules[0]);
  }

  /// Appends the triangles; what it appended counts only where it returns PolygonShape::simple.
  PolygonShape clip(std::vector<std::array<std::int32_t, 3>>& triangles) {
    while (ring_.left_count() > 3) {
      const std::optional<std::size_t> ear = take_ear();
      if (tests_ > kMostEarTests) return PolygonShape::too_complex;
      if (!ear) return PolygonShape::self_crossing;
      triangles.push_back(vertices(*ear));
      cut(*ear);
    }
    const std::size_t last = ring_.first_left();
    const bool fits = has_distinct_vertices(last) && turn(last) >= -kFlatSine;
    if (!fits) return PolygonShape::self_crossing;
    triangles.push_back(vertices(last));
    return PolygonShape::simple;
  }

 private:
  /// What an ear may be. The rules are tried in this order, and from the first one again after every cut.
  struct Rule {
    bool flat;      // the ear may have no area
    bool existing;  // the diagonal may be an edge already
  };
  static constexpr std::array<Rule, 4> kRules = {{{false, false}, {true, false}, {false, true}, {true, true}}};

  /// Sine of the angle at a from b to p: positive where p is to the left of the line from a to b.
  double side(std::size_t a, std::size_t b, std::size_t p) const {
    return sine(plane_[b] - plane_[a], plane_[p] - plane_[a]);
  }

  /// Sine of the turn at a corner: positive where it is convex.
  double turn(std::size_t i) const {
    return sine(plane_[i] - plane_[ring_.before(i)], plane_[ring_.after(i)] - plane_[i]);
  }

  static double sine(const Vec2& u, const Vec2& v) {
    const double lengths = u.norm() * v.norm();
    return lengths > 0 ? cross(u, v) / lengths : 0;
  }

  /// The best ear; where no good one is left, a worse one by the next rule. Nothing where there is none at all.
  std::optional<std::size_t> take_ear() {
    while (!queue_.empty()) {
      const EarCandidate best = queue_.top();
      queue_.pop();
      if (ring_.is_current(best)) return best.corner;
    }
    for (const Rule& rule : kRules) {
      queue_all(rule);
      if (queue_.empty()) continue;
      const std::size_t ear = queue_.top().corner;
      if (rule.flat || rule.existing)
        queue_ = {};
      else
        queue_.pop();
      return ear;
    }
    return std::nullopt;
  }

  void queue_all(const Rule& rule) {
    for (std::size_t i = 0; i < ring_.corner_count(); ++i) {
      if (ring_.is_left(i)) queue(i, rule);
    }
  }

  void queue(std::size_t i, const Rule& rule) {
    if (is_ear(i, rule)) queue_.push(ring_.candidate(i, quality(i)));
  }

  bool is_ear(std::size_t i, const Rule& rule) {
    const double sine = turn(i);
    if (rule.flat ? sine < -kFlatSine : sine <= kFlatSine) return false;
    const std::size_t a = ring_.before(i), b = ring_.after(i);
    if (!has_distinct_vertices(i) || space_[a] == space_[b]) return false;
    if (!rule.existing && is_edge_(polygon_[a], polygon_[b])) return false;
    return !is_blocked(i);
  }

  /// Whether a corner that is not convex lies in the ear of corner i. One at the position of a corner of the ear does
  /// not count.
  bool is_blocked(std::size_t i) {
    tests_ += static_cast<std::int64_t>(blockers_.size());
    const std::size_t a = ring_.before(i), b = ring_.after(i);
    return std::any_of(blockers_.begin(), blockers_.end(), [&](std::size_t p) {
      if (!ring_.is_left(p) || p == a || p == i || p == b) return false;
      if (plane_[p] == plane_[a] || plane_[p] == plane_[i] || plane_[p] == plane_[b]) return false;
      return side(a, i, p) >= -kFlatSine && side(i, b, p) >= -kFlatSine && side(b, a, p) >= -kFlatSine &&
             is_in_box(i, p);
    });
  }

  /// Whether p lies in the bounding box of the ear of corner i: for flat ears.
  bool is_in_box(std::size_t i, std::size_t p) const {
    const Vec2 &a = plane_[ring_.before(i)], &b = plane_[ring_.after(i)];
    const Vec2 low = a.cwiseMin(plane_[i]).cwiseMin(b);
    const Vec2 high = a.cwiseMax(plane_[i]).cwiseMax(b);
    const auto within = [](double x, double l, double h) { return x >= l - kFlatSine && x <= h + kFlatSine; };
    return within(plane_[p].x(), low.x(), high.x()) && within(plane_[p].y(), low.y(), high.y());
  }

  /// Twice the area over the sum of the squared sides: largest for the equilateral triangle.
  double quality(std::size_t i) const {
    const Vec3 &a = space_[ring_.before(i)], &b = space_[i], &c = space_[ring_.after(i)];
    return (b - a).cross(c - a).norm() / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
  }

  void cut(std::size_t ear) {
    ring_.remove(ear);
    for (const std::size_t i : {ring_.before(ear), ring_.after(ear)}) queue(i, kRules[0]);
  }

  std::array<std::int32_t, 3> vertices(std::size_t i) const {
    return {polygon_[ring_.before(i)], polygon_[i], polygon_[ring_.after(i)]};
  }

  /// A vertex may come twice round the polygon.
  bool has_distinct_vertices(std::size_t i) const {
    const auto [a, v, b] = vertices(i);
    return a != b && a != v && b != v;
  }

  std::span<const std::int32_t> polygon_;
  const std::vector<Vec3>& space_;
  const std::vector<Vec2>& plane_;
  const EdgeQuery& is_edge_;
  PolygonRing ring_;
  std::int64_t tests_ = 0;             // of points in triangles
  std::vector<std::size_t> blockers_;  // corners that are not convex at the start: only they can lie in an ear
  std::priority_queue<EarCandidate> queue_;
};

}  // namespace

PolygonShape triangulate_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions,
                                 const EdgeQuery& is_edge, std::vector<std::array<std::int32_t, 3>>& triangles) {
  const ProjectedPolygon projected = project_polygon(polygon, positions);
  if (!projected.turns_once) return PolygonShape::self_crossing;
  const std::size_t before = triangles.size();
  const PolygonShape shape = SoupEarClipper(polygon, projected, is_edge).clip(triangles);
  if (shape != PolygonShape::simple) triangles.resize(before);
  return shape;
}

}  // namespace gvd
