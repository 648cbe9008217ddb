// Cuts the polygons of a soup into triangles, if possible along diagonals that are not edges yet.
//
// A second edge between two vertices of the mesh would count as the same edge, with four faces. So a diagonal that
// already is an edge is the last choice. Quadrilaterals, the most frequent polygons, are cut along the better diagonal;
// larger polygons are projected along their normal and cut by clipping ears. It is not known in advance whether the
// projected polygon is simple; if no ear remains, it is folded or crosses itself. Ears are chosen by four rules, from
// good ears to flat ears along existing edges.
// Source: Newell's formula for the normal (M. E. Newell, R. G. Newell and T. L. Sancha, A solution to the hidden surface
// problem, 1972); ear clipping (G. H. Meisters, Polygons have ears, 1975).
// Invariant: each triangle of a polygon except the last is cut off along the side from its third corner to its first.
// Only corners that are not convex at the start can lie in an ear, then or later, so only these corners are tested.
#include "mesh/repair/triangulate_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>
#include <unordered_set>

#include "base/ear_clipping.hpp"
#include "base/plane.hpp"
#include "gvd/text.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {
namespace {

/// The second diagonal of a quadrilateral is taken only if it is better by more than this fraction, so that rounding
/// does not decide between the diagonals of a square. Dimensionless; far above the rounding of a few operations.
constexpr double kBetterDiagonal = 1e-6;

/// The sine of an angle at or below this counts as 0. Coordinates scaled to 1 have a rounding error of about 1e-16
/// each, and the sine of a corner between sides a thousandth as long has an error of about 1e-13. This is ten times as
/// much.
constexpr double kFlatSine = 1e-12;

/// Largest number of point-in-triangle tests for one polygon, which take about a second. Concave polygons of about
/// 20,000 corners reach it.
constexpr std::int64_t kMostEarTests = 100'000'000;

enum class PolygonShape {
  simple,         ///< cut into triangles
  self_crossing,  ///< crosses itself in the projection along its normal; no triangle was added
  too_complex,    ///< more than kMostEarTests would be needed; no triangle was added
};

/// Twice the area divided by the sum of the squared sides: largest for an equilateral triangle, 0 for a flat one.
double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).norm() / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
}

/// Moves the first corner to the origin and scales the polygon into a unit box, so that no product overflows or
/// underflows.
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

/// Fills `plane` and `is_on_line`. Returns false if the polygon has no normal although it does not lie on a line.
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

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
}

/// The edges of all polygons and the added diagonals. The hash set is only asked for membership, so its order does not
/// affect the output.
class KnownEdges {
 public:
  explicit KnownEdges(const WorkPolygons& polygons) {
    edges_.reserve(polygons.corners.size());
    for (std::size_t p = 0; p < polygons.count(); ++p) {
      const auto polygon = polygons.polygon(p);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        edges_.push_back(edge_key(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1]));
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  bool contains(std::int32_t a, std::int32_t b) const {
    const std::uint64_t key = edge_key(a, b);
    return diagonals_.contains(key) || std::binary_search(edges_.begin(), edges_.end(), key);
  }
  void add_diagonal(std::int32_t a, std::int32_t b) { diagonals_.insert(edge_key(a, b)); }

 private:
  std::vector<std::uint64_t> edges_;
  std::unordered_set<std::uint64_t> diagonals_;
};

class SoupEarClipper {
 public:
  SoupEarClipper(std::span<const std::int32_t> polygon, const ProjectedPolygon& projected, const KnownEdges& known)
      : polygon_(polygon),
        space_(projected.space),
        plane_(projected.plane),
        known_(known),
        ring_(projected.plane.size()) {
    for (std::size_t i = 0; i < ring_.corner_count(); ++i) {
      if (turn(i) <= kFlatSine) blockers_.push_back(i);
    }
    queue_all(kRules[0]);
  }

  /// Appends the triangles, which are valid only if it returns PolygonShape::simple.
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
  /// A rule for ears. The rules are tried in order, beginning again with the first after every cut.
  struct Rule {
    bool flat;      // the ear may have no area
    bool existing;  // the diagonal may be an existing edge
  };
  static constexpr std::array<Rule, 4> kRules = {{{false, false}, {true, false}, {false, true}, {true, true}}};

  /// Sine of the angle at a from b to p; positive if p is to the left of the line from a to b.
  double side(std::size_t a, std::size_t b, std::size_t p) const {
    return sine(plane_[b] - plane_[a], plane_[p] - plane_[a]);
  }

  /// Sine of the turn at a corner; positive if the corner is convex.
  double turn(std::size_t i) const {
    return sine(plane_[i] - plane_[ring_.before(i)], plane_[ring_.after(i)] - plane_[i]);
  }

  static double sine(const Vec2& u, const Vec2& v) {
    const double lengths = u.norm() * v.norm();
    return lengths > 0 ? cross(u, v) / lengths : 0;
  }

  /// Takes the best ear by the first rule that some ear satisfies. Returns nothing if there is no ear at all.
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
    if (!is_ear(i, rule)) return;
    queue_.push(ring_.candidate(i, triangle_quality(space_[ring_.before(i)], space_[i], space_[ring_.after(i)])));
  }

  bool is_ear(std::size_t i, const Rule& rule) {
    const double sine = turn(i);
    if (rule.flat ? sine < -kFlatSine : sine <= kFlatSine) return false;
    const std::size_t a = ring_.before(i), b = ring_.after(i);
    if (!has_distinct_vertices(i) || space_[a] == space_[b]) return false;
    if (!rule.existing && known_.contains(polygon_[a], polygon_[b])) return false;
    return !is_blocked(i);
  }

  /// Whether a corner that is not convex lies in the ear of corner i. Corners at the same position as a corner of the
  /// ear do not count.
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

  /// Whether p lies in the bounding box of the ear of corner i. Used for flat ears.
  bool is_in_box(std::size_t i, std::size_t p) const {
    const Vec2 &a = plane_[ring_.before(i)], &b = plane_[ring_.after(i)];
    const Vec2 low = a.cwiseMin(plane_[i]).cwiseMin(b), high = a.cwiseMax(plane_[i]).cwiseMax(b);
    return (plane_[p].array() >= low.array() - kFlatSine).all() &&
           (plane_[p].array() <= high.array() + kFlatSine).all();
  }

  void cut(std::size_t ear) {
    ring_.remove(ear);
    for (const std::size_t i : {ring_.before(ear), ring_.after(ear)}) queue(i, kRules[0]);
  }

  std::array<std::int32_t, 3> vertices(std::size_t i) const {
    return {polygon_[ring_.before(i)], polygon_[i], polygon_[ring_.after(i)]};
  }

  /// Whether the ear of corner i has three different vertices. A vertex may occur twice in the polygon.
  bool has_distinct_vertices(std::size_t i) const {
    const auto [a, v, b] = vertices(i);
    return a != b && a != v && b != v;
  }

  std::span<const std::int32_t> polygon_;
  const std::vector<Vec3>& space_;
  const std::vector<Vec2>& plane_;
  const KnownEdges& known_;
  PolygonRing ring_;
  std::int64_t tests_ = 0;             // number of point-in-triangle tests so far
  std::vector<std::size_t> blockers_;  // corners that are not convex at the start; only these can lie in an ear
  std::priority_queue<EarCandidate> queue_;
};

/// Cuts a polygon in space into triangles of its own orientation by clipping ears, the best shaped ones first.
///
/// Inputs: four or more corners, neighbours at different positions; a vertex may occur twice (a polygon with a bridge
/// to its hole). A diagonal that already is an edge is used only if no other diagonal is left.
/// Appends the triangles to `triangles`. Diagonals have a positive length. Deterministic.
/// Cost: O(n log n + n r) time for n corners, r of them not convex.
PolygonShape triangulate_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions,
                                 const KnownEdges& known, std::vector<std::array<std::int32_t, 3>>& triangles) {
  const ProjectedPolygon projected = project_polygon(polygon, positions);
  if (!projected.turns_once) return PolygonShape::self_crossing;
  const std::size_t before = triangles.size();
  const PolygonShape shape = SoupEarClipper(polygon, projected, known).clip(triangles);
  if (shape != PolygonShape::simple) triangles.resize(before);
  return shape;
}

/// Kinds of quadrilaterals, in the order in which they are tried. The two triangles of a simple one face the same way.
/// As a last resort, the diagonal may already be an edge of the mesh, which is cut apart later.
enum class Quad { simple, crossing, along_edge };

/// Cuts a quadrilateral along its better diagonal. Returns false if neither diagonal is allowed.
bool split_quad(std::span<const std::int32_t> q, const std::vector<Vec3>& positions, const KnownEdges& known,
                Quad shape, std::vector<std::array<std::int32_t, 3>>& faces) {
  if (q[0] == q[2] || q[1] == q[3]) return false;
  // The quality of the diagonal from corner i to i + 2, which is the quality of the worse of its two triangles. It is 0
  // if a triangle is flat, if the two triangles must face the same way and do not, or if the diagonal already is an
  // edge and must not be.
  const auto quality = [&](std::size_t i) {
    const Vec3 &a = positions[q[i]], &b = positions[q[i + 1]], &c = positions[q[i + 2]], &d = positions[q[(i + 3) % 4]];
    const Vec3 normal_b = (b - a).cross(c - a), normal_d = (c - a).cross(d - a);
    if (shape == Quad::simple && !(normal_b.dot(normal_d) > 0)) return 0.0;
    if (shape != Quad::along_edge && known.contains(q[i], q[i + 2])) return 0.0;
    return std::min(triangle_quality(a, b, c), triangle_quality(a, c, d));
  };
  const double first = quality(0), second = quality(1);
  if (std::max(first, second) == 0) return false;
  if (second > first * (1 + kBetterDiagonal)) {
    faces.push_back({q[3], q[0], q[1]});
    faces.push_back({q[1], q[2], q[3]});
  } else {
    faces.push_back({q[0], q[1], q[2]});
    faces.push_back({q[0], q[2], q[3]});
  }
  return true;
}

[[noreturn]] void refuse_polygon(PolygonShape shape, std::size_t corners, std::int32_t origin) {
  refuse_soup(
      shape == PolygonShape::too_complex
          ? fmt::format("face {} has {} corners in too complex a shape; cut it into smaller ones", origin, corners)
          : fmt::format("face {} with its {} corners is folded or crosses itself; cut it into triangles", origin,
                        corners),
      origin);
}

}  // namespace

ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions) {
  ProjectedPolygon projected;
  projected.space = scale(polygon, positions);
  projected.turns_once = project(projected) && (projected.is_on_line || turns_once(projected.plane));
  return projected;
}

WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log) {
  WorkFaces work;
  const std::size_t triangles = polygons.corners.size() - 2 * polygons.count();
  if (triangles > 0x7fffffff / 3) {
    refuse_soup(fmt::format("{} triangles are more than 32-bit ids can count", triangles), -1);
  }
  work.faces.reserve(triangles);
  if (polygons.corners.size() == 3 * polygons.count()) {
    for (std::size_t p = 0; p < polygons.count(); ++p) {
      const auto triangle = polygons.polygon(p);
      work.faces.push_back({triangle[0], triangle[1], triangle[2]});
    }
    work.origin = std::move(polygons.origin);
    return work;
  }
  work.origin.reserve(triangles);
  KnownEdges known(polygons);
  std::int64_t crossing_quads = 0;
  std::int32_t first_crossing = -1;
  for (std::size_t p = 0; p < polygons.count(); ++p) {
    const auto polygon = polygons.polygon(p);
    const std::int32_t origin = polygons.origin[p];
    const std::size_t begin = work.faces.size();
    const auto is_split = [&](Quad shape) {
      return polygon.size() == 4 && split_quad(polygon, positions, known, shape, work.faces);
    };
    if (polygon.size() == 3) {
      work.faces.push_back({polygon[0], polygon[1], polygon[2]});
    } else if (!is_split(Quad::simple)) {
      const PolygonShape shape = triangulate_polygon(polygon, positions, known, work.faces);
      if (shape != PolygonShape::simple) {
        // A quadrilateral that is folded or crosses itself is cut only if that gives two triangles with an area.
        if (!is_split(Quad::crossing) && !is_split(Quad::along_edge)) refuse_polygon(shape, polygon.size(), origin);
        if (crossing_quads++ == 0) first_crossing = origin;
      }
    }
    work.origin.resize(work.faces.size(), origin);
    for (std::size_t f = begin; f + 1 < work.faces.size(); ++f) known.add_diagonal(work.faces[f][2], work.faces[f][0]);
  }
  log.add(DefectKind::crossing_quads, crossing_quads, first_crossing,
          fmt::format("{}, first face {}",
                      counted(crossing_quads, "quadrilateral is folded or crosses itself",
                              "quadrilaterals are folded or cross themselves"),
                      first_crossing),
          "cut along a diagonal");
  return work;
}

}  // namespace gvd
