// Whether two faces of a mesh, or a segment and a triangle, intersect: exactly, by the signs of exact_predicates.cpp.
//
// Before that, quick tests find most of the faces that certainly lie apart.
#include "dual/faces_intersect.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "base/plane.hpp"
#include "dual/exact_predicates.hpp"

namespace gvd {
namespace {

/// A plane certainly separates points if their distances from it, as products with its normal, differ by more than this
/// fraction of both lengths. Rounding is some ten units in the last place. Dimensionless.
constexpr double kApart = 1e-12;

Vec2 drop_axis(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// Whether c lies between a and b; c is on the line from a to b, or anywhere where a == b.
bool lies_between(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (a.cwiseMin(b).array() <= c.array()).all() && (c.array() <= a.cwiseMax(b).array()).all();
}

bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  const int pqa = exact_orientation(p, q, a), pqb = exact_orientation(p, q, b);
  const int abp = exact_orientation(a, b, p), abq = exact_orientation(a, b, q);
  if (pqa != pqb && abp != abq) return true;
  return (pqa == 0 && lies_between(p, q, a)) || (pqb == 0 && lies_between(p, q, b)) ||
         (abp == 0 && lies_between(a, b, p)) || (abq == 0 && lies_between(a, b, q));
}

/// Segments in one plane meet if and only if their projections along all three axes do. At least one projection maps
/// the plane, or the common line, one to one.
bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  if (exact_orientation(p, q, a, b) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!segments_meet(drop_axis(p, axis), drop_axis(q, axis), drop_axis(a, axis), drop_axis(b, axis))) return false;
  }
  return true;
}

struct ProjectedTriangle {
  int axis = 0;
  int orientation = 0;
  std::array<Vec2, 3> corners;
};

/// A projection in which the triangle has an area; none for a degenerate triangle.
std::optional<ProjectedTriangle> project(const Triangle& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    ProjectedTriangle flat;
    flat.axis = axis;
    for (std::size_t i = 0; i < 3; ++i) flat.corners[i] = drop_axis(triangle[i], axis);
    flat.orientation = exact_orientation(flat.corners[0], flat.corners[1], flat.corners[2]);
    if (flat.orientation != 0) return flat;
  }
  return std::nullopt;
}

bool contains(const ProjectedTriangle& triangle, const Vec2& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = exact_orientation(triangle.corners[i], triangle.corners[(i + 1) % 3], p);
    if (side == -triangle.orientation) return false;
  }
  return true;
}

/// segment_meets_triangle for a segment in the triangle's plane, and for any segment if the triangle is degenerate.
bool flat_segment_meets(const Vec3& p, const Vec3& q, const Triangle& triangle) {
  const auto flat = project(triangle);
  if (flat && contains(*flat, drop_axis(p, flat->axis))) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segments_meet(p, q, triangle[i], triangle[(i + 1) % 3])) return true;
  }
  return false;
}

/// The corners of a face that are not corners of another face.
class OwnCorners {
 public:
  OwnCorners(const PlacedFace& f, const PlacedFace& g) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& at = f.corners[i];
      if (std::find(g.ids.begin(), g.ids.end(), f.ids[i]) == g.ids.end()) {
        own_[own_count_++] = at;
      } else {
        shared_[shared_count_++] = at;
      }
    }
  }

  std::span<const Vec3> own() const { return {own_.data(), own_count_}; }
  std::span<const Vec3> shared() const { return {shared_.data(), shared_count_}; }

 private:
  std::array<Vec3, 3> own_, shared_;
  std::size_t own_count_ = 0, shared_count_ = 0;
};

/// Whether all of the points lie strictly on one side of the triangle's plane.
bool lie_beside(const Triangle& triangle, std::span<const Vec3> points) {
  const auto side = [&](const Vec3& p) { return exact_orientation(triangle[0], triangle[1], triangle[2], p); };
  const int first = side(points.front());
  return first != 0 && std::all_of(points.begin() + 1, points.end(), [&](const Vec3& p) { return side(p) == first; });
}

/// Whether the first points certainly lie beyond a plane with this normal, and the second ones before it. `at` may be
/// any point; a point on the plane is best.
bool are_parted(std::span<const Vec3> first, std::span<const Vec3> second, const Vec3& at, const Vec3& normal) {
  double least = kInfinity, most = -kInfinity, reach = 0;
  const auto height = [&](const Vec3& p) {
    const Vec3 to = p - at;
    reach = std::max(reach, to.squaredNorm());
    return to.dot(normal);
  };
  for (const Vec3& p : first) least = std::min(least, height(p));
  for (const Vec3& p : second) most = std::max(most, height(p));
  return least - most > kApart * std::sqrt(reach * normal.squaredNorm());
}

/// Whether two faces with one common vertex certainly lie apart, on the two sides of a plane through it.
bool lie_apart_at_vertex(const OwnCorners& first, const OwnCorners& second) {
  const Vec3& at = first.shared()[0];
  const auto mean_direction = [&](const OwnCorners& of) -> Vec3 {
    return (of.own()[0] - at).normalized() + (of.own()[1] - at).normalized();
  };
  const Vec3 normal = mean_direction(first) - mean_direction(second);
  const std::span<const Vec3> vertex(&at, 1);
  return are_parted(first.own(), vertex, at, normal) && are_parted(vertex, second.own(), at, normal);
}

/// Whether a plane through an edge of the first face, and normal to the face, certainly separates the two faces.
bool edge_parts(const Triangle& first, const Triangle& second) {
  const Vec3 normal = (first[1] - first[0]).cross(first[2] - first[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 inward = normal.cross(first[(i + 1) % 3] - first[i]);
    if (are_parted(first, second, first[i], inward)) return true;
  }
  return false;
}

/// Whether two faces with a common edge certainly lie on the two sides of a plane through it.
bool lie_apart_at_edge(const OwnCorners& first, const OwnCorners& second) {
  const Vec3 &from = first.shared()[0], along = first.shared()[1] - from;
  const Vec3 u = first.own()[0] - from, v = second.own()[0] - from;
  return along.cross(u).dot(along.cross(v)) < -kApart * along.squaredNorm() * u.norm() * v.norm();
}

/// Whether two faces with a common edge lie in one plane, on the same side of the edge. `corner` and `other` are
/// opposite to it.
bool are_folded(const Triangle& triangle, const Vec3& corner, const Vec3& other) {
  if (exact_orientation(triangle[0], triangle[1], triangle[2], other) != 0) return false;
  const auto flat = project(triangle);
  if (!flat) return false;
  const Vec2 apex = drop_axis(corner, flat->axis), p = drop_axis(other, flat->axis);
  const auto at = std::find(flat->corners.begin(), flat->corners.end(), apex) - flat->corners.begin();
  const auto next = [&](std::ptrdiff_t i) { return flat->corners[(at + i) % 3]; };
  return exact_orientation(next(1), next(2), p) == flat->orientation;
}

bool any_edge_meets(const Triangle& edges, const Triangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets_triangle(edges[i], edges[(i + 1) % 3], triangle)) return true;
  }
  return false;
}

}  // namespace

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const int at_p = exact_orientation(a, b, c, p), at_q = exact_orientation(a, b, c, q);
  if (at_p == 0 && at_q == 0) return flat_segment_meets(p, q, triangle);
  if (at_p == at_q) return false;
  // The line through p and q crosses the plane in one point: it passes all three edges on the same side, or on one.
  const std::array<int, 3> sides{exact_orientation(p, q, a, b), exact_orientation(p, q, b, c),
                                 exact_orientation(p, q, c, a)};
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  return *least >= 0 || *most <= 0;
}

// Flat surfaces have many faces in one plane near each other. Planes that separate them save exact determinants.
bool faces_intersect(const PlacedFace& f, const PlacedFace& g) {
  const Triangle &first = f.corners, &second = g.corners;
  const OwnCorners of_first(f, g), of_second(g, f);
  const std::span<const Vec3> own = of_first.own(), others = of_second.own();
  if (own.empty()) return true;
  if (own.size() == 1) return !lie_apart_at_edge(of_first, of_second) && are_folded(first, own[0], others[0]);
  if (own.size() == 2 && lie_apart_at_vertex(of_first, of_second)) return false;
  if (own.size() == 3 && (edge_parts(first, second) || edge_parts(second, first))) return false;
  if (lie_beside(first, others) || lie_beside(second, own)) return false;
  if (own.size() == 3) return any_edge_meets(first, second) || any_edge_meets(second, first);
  return segment_meets_triangle(own[0], own[1], second) || segment_meets_triangle(others[0], others[1], first);
}

}  // namespace gvd
