// One polygon of a soup becomes triangles: projected along its normal, then cut by clipping ears.
//
// Source: Newell's formula for the normal (M. E. Newell, R. G. Newell and T. L. Sancha, A solution to the hidden surface
// problem, 1972); ear clipping (G. H. Meisters, Polygons have ears, 1975). Nobody knows whether the polygon is simple:
// where no ear is left, it crosses itself. Ears come by four rules, from good ones to flat ones along existing edges.
// Invariant: only corners that are not convex at the start can lie in an ear, then or later, so only they are tested.
#include "mesh/repair/triangulate_soup_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>

#include "base/ear_clipping.hpp"
#include "base/plane.hpp"

namespace gvd {
namespace {

/// Moves the first corner to the origin and the others into a unit box, so that no product overflows or underflows.
std::vector<Vec3> scale(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions) {
  const Vec3& origin = positions[polygon[0]];
  std::vector<Vec3> space;
  double extent = 0;
  for (const std::int32_t v : polygon) {
    space.push_back(positions[v] - origin);
    extent = std::max(extent, space.back().cwiseAbs().maxCoeff());
  }
  for (Vec3& p : space) p /= extent;
  return space;
}

/// Fills `plane` and `is_on_line`. False where the polygon has no normal and does not lie on a line.
bool project(ProjectedPolygon& polygon) {
  const std::vector<Vec3>& space = polygon.space;
  Vec3 normal = Vec3::Zero();
  Vec3 far = Vec3::Zero();
  double widest = 0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    normal += space[i].cross(space[(i + 1) % space.size()]);
    if (space[i].squaredNorm() > far.squaredNorm()) far = space[i];
  }
  for (const Vec3& p : space) widest = std::max(widest, p.cross(far).norm());
  const bool on_line = widest <= kFlatSine * far.squaredNorm();
  if (!on_line && normal.norm() <= kFlatSine) return false;
  polygon.is_on_line = on_line;
  const Vec3 z = on_line ? far.unitOrthogonal() : Vec3(normal.normalized());
  const Vec3 x = on_line ? Vec3(far.normalized()) : z.unitOrthogonal();
  const Vec3 y = z.cross(x);
  for (const Vec3& p : space) polygon.plane.emplace_back(p.dot(x), on_line ? 0 : p.dot(y));
  return true;
}

bool turns_once(const std::vector<Vec2>& corners) {
  double sum = 0;
  for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
    const Vec2 in = corners[i] - corners[(i + n - 1) % n];
    const Vec2 out = corners[(i + 1) % n] - corners[i];
    sum += std::atan2(cross(in, out), in.dot(out));
  }
  return std::abs(sum - 2 * std::numbers::pi) < 1;
}

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
  /// A rule for ears. The rules are tried in this order, and from the first one again after every cut.
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

  /// Whether a corner that is not convex lies in the ear of corner i. A corner at the position of one of the ear's own
  /// does not count.
  bool is_blocked(std::size_t i) {
    tests_ += std::ssize(blockers_);
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

ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions) {
  ProjectedPolygon projected;
  projected.space = scale(polygon, positions);
  projected.turns_once = project(projected) && (projected.is_on_line || turns_once(projected.plane));
  return projected;
}

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
