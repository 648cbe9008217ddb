#include "mesh/repair/triangulate_soup_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "base/plane.hpp"

namespace gvd {
namespace {

/// A corner whose sine is at or below this is taken for flat. Coordinates scaled to 1 carry a rounding of about 1e-16
/// each, the sine of a corner between sides a thousandth as long some 1e-13; ten times that.
constexpr double kFlatSine = 1e-12;

class EarClipper {
 public:
  EarClipper(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions, const EdgeQuery& is_edge,
             std::vector<std::array<std::int32_t, 3>>& triangles)
      : polygon_(polygon), is_edge_(is_edge), triangles_(triangles), size_(static_cast<int>(polygon.size())) {
    scale(positions);
  }

  PolygonShape clip() {
    if (!project() || !turns_once()) return PolygonShape::self_crossing;
    const std::size_t begin = triangles_.size();
    link();
    int left = size_;
    while (left > 3) {
      const int ear = take_ear();
      if (tests_ > kMostEarTests) return give_up(begin, PolygonShape::too_complex);
      if (ear < 0) return give_up(begin, PolygonShape::self_crossing);
      cut(ear);
      --left;
    }
    const int last = first_alive();
    const bool fits = distinct(last) && turn(last) >= -kFlatSine;
    if (!fits) return give_up(begin, PolygonShape::self_crossing);
    emit(last);
    return PolygonShape::simple;
  }

 private:
  // What a diagonal may be; taken in this order, and from the top again after every cut.
  struct Rule {
    bool flat;      // the ear may have no area
    bool existing;  // the diagonal may be an edge already
  };
  static constexpr std::array<Rule, 4> kRules = {{{false, false}, {true, false}, {false, true}, {true, true}}};

  struct Candidate {
    double quality;
    int corner;
    int version;
    bool operator<(const Candidate& other) const {
      return quality != other.quality ? quality < other.quality : corner > other.corner;
    }
  };

  // Into the unit box round the first corner, so that no product over- or underflows.
  void scale(const std::vector<Vec3>& positions) {
    const Vec3& origin = positions[static_cast<std::size_t>(polygon_[0])];
    double extent = 0;
    for (const std::int32_t v : polygon_) {
      space_.push_back(positions[static_cast<std::size_t>(v)] - origin);
      extent = std::max(extent, space_.back().cwiseAbs().maxCoeff());
    }
    for (Vec3& p : space_) p /= extent;
  }

  // Along Newell's normal. A polygon without one lies on a line, or crosses itself: then false.
  bool project() {
    Vec3 normal = Vec3::Zero();
    Vec3 far = Vec3::Zero();
    double widest = 0;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      normal += space_[i].cross(space_[(i + 1) % space_.size()]);
      if (space_[i].squaredNorm() > far.squaredNorm()) far = space_[i];
    }
    for (const Vec3& p : space_) widest = std::max(widest, p.cross(far).norm());
    const bool on_a_line = widest <= kFlatSine * far.squaredNorm();
    if (!on_a_line && normal.norm() <= kFlatSine) return false;
    on_a_line_ = on_a_line;
    const Vec3 z = on_a_line ? far.unitOrthogonal() : Vec3(normal.normalized());
    const Vec3 x = on_a_line ? Vec3(far.normalized()) : z.unitOrthogonal();
    const Vec3 y = z.cross(x);
    for (const Vec3& p : space_) plane_.emplace_back(p.dot(x), on_a_line ? 0 : p.dot(y));
    return true;
  }

  // The sine of the turn at a corner; positive where it is convex.
  double turn(int i) const {
    const Vec2 in = at(i) - at(previous_[index(i)]);
    const Vec2 out = at(next_[index(i)]) - at(i);
    const double lengths = in.norm() * out.norm();
    return lengths > 0 ? cross(in, out) / lengths : 0;
  }

  // A simple polygon turns by 2 pi once round.
  bool turns_once() const {
    if (on_a_line_) return true;
    double sum = 0;
    for (int i = 0; i < size_; ++i) {
      const Vec2 in = at(i) - at((i + size_ - 1) % size_);
      const Vec2 out = at((i + 1) % size_) - at(i);
      sum += std::atan2(cross(in, out), in.dot(out));
    }
    return std::abs(sum - 2 * std::numbers::pi) < 1;
  }

  void link() {
    next_.resize(index(size_));
    previous_.resize(index(size_));
    version_.assign(index(size_), 0);
    alive_.assign(index(size_), 1);
    for (int i = 0; i < size_; ++i) {
      next_[index(i)] = (i + 1) % size_;
      previous_[index(i)] = (i + size_ - 1) % size_;
    }
    for (int i = 0; i < size_; ++i) {
      if (turn(i) <= kFlatSine) blockers_.push_back(i);
    }
    queue_all(kRules[0]);
  }

  // The best ear; where no good one is left, a worse one by the next rule. -1 where there is none at all.
  int take_ear() {
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (alive_[index(best.corner)] && best.version == version_[index(best.corner)]) return best.corner;
    }
    for (const Rule& rule : kRules) {
      queue_all(rule);
      if (queue_.empty()) continue;
      const int ear = queue_.top().corner;
      if (rule.flat || rule.existing)
        queue_ = {};
      else
        queue_.pop();
      return ear;
    }
    return -1;
  }

  void queue_all(const Rule& rule) {
    for (int i = 0; i < size_; ++i) {
      if (alive_[index(i)]) queue(i, rule);
    }
  }

  void queue(int i, const Rule& rule) {
    if (is_ear(i, rule)) queue_.push({quality(i), i, version_[index(i)]});
  }

  bool is_ear(int i, const Rule& rule) {
    const double sine = turn(i);
    if (rule.flat ? sine < -kFlatSine : sine <= kFlatSine) return false;
    const int a = previous_[index(i)];
    const int b = next_[index(i)];
    if (!distinct(i) || space_[index(a)] == space_[index(b)]) return false;
    if (!rule.existing && is_edge_(polygon_[index(a)], polygon_[index(b)])) return false;
    return !is_blocked(a, i, b);
  }

  // Whether a corner that is not convex lies in the ear; those at the very place of one of its corners do not count.
  bool is_blocked(int a, int i, int b) {
    tests_ += static_cast<std::int64_t>(blockers_.size());
    return std::any_of(blockers_.begin(), blockers_.end(), [&](int p) {
      if (!alive_[index(p)] || p == a || p == i || p == b) return false;
      if (at(p) == at(a) || at(p) == at(i) || at(p) == at(b)) return false;
      return side(a, i, p) >= -kFlatSine && side(i, b, p) >= -kFlatSine && side(b, a, p) >= -kFlatSine &&
             between(a, i, b, p);
    });
  }

  // Positive where p is to the left of the line from a to b: the sine of the angle at a.
  double side(int a, int b, int p) const {
    const Vec2 u = at(b) - at(a);
    const Vec2 v = at(p) - at(a);
    const double lengths = u.norm() * v.norm();
    return lengths > 0 ? cross(u, v) / lengths : 0;
  }

  // For flat ears: whether p is within the ear's bounding box.
  bool between(int a, int i, int b, int p) const {
    const Vec2 low = at(a).cwiseMin(at(i)).cwiseMin(at(b));
    const Vec2 high = at(a).cwiseMax(at(i)).cwiseMax(at(b));
    const auto within = [](double x, double l, double h) { return x >= l - kFlatSine && x <= h + kFlatSine; };
    return within(at(p).x(), low.x(), high.x()) && within(at(p).y(), low.y(), high.y());
  }

  // Twice the area by the sum of the squared sides: largest for the equilateral triangle.
  double quality(int i) const {
    const Vec3& a = space_[index(previous_[index(i)])];
    const Vec3& b = space_[index(i)];
    const Vec3& c = space_[index(next_[index(i)])];
    return (b - a).cross(c - a).norm() / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
  }

  void cut(int ear) {
    emit(ear);
    alive_[index(ear)] = 0;
    const int a = previous_[index(ear)];
    const int b = next_[index(ear)];
    next_[index(a)] = b;
    previous_[index(b)] = a;
    for (const int i : {a, b}) {
      ++version_[index(i)];
      queue(i, kRules[0]);
    }
  }

  void emit(int i) {
    triangles_.push_back({polygon_[index(previous_[index(i)])], polygon_[index(i)], polygon_[index(next_[index(i)])]});
  }

  bool distinct(int i) const {
    const std::int32_t a = polygon_[index(previous_[index(i)])];
    const std::int32_t b = polygon_[index(next_[index(i)])];
    return a != b && a != polygon_[index(i)] && b != polygon_[index(i)];
  }

  PolygonShape give_up(std::size_t begin, PolygonShape reason) {
    triangles_.resize(begin);
    return reason;
  }

  int first_alive() const { return static_cast<int>(std::find(alive_.begin(), alive_.end(), 1) - alive_.begin()); }
  const Vec2& at(int i) const { return plane_[index(i)]; }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  std::span<const std::int32_t> polygon_;
  const EdgeQuery& is_edge_;
  std::vector<std::array<std::int32_t, 3>>& triangles_;
  int size_;
  bool on_a_line_ = false;
  std::int64_t tests_ = 0;
  std::vector<Vec3> space_;
  std::vector<Vec2> plane_;
  std::vector<int> next_, previous_, version_, blockers_;
  std::vector<char> alive_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

PolygonShape triangulate_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions,
                                 const EdgeQuery& is_edge, std::vector<std::array<std::int32_t, 3>>& triangles) {
  return EarClipper(polygon, positions, is_edge, triangles).clip();
}

}  // namespace gvd
