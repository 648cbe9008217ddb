#include "intersection/faces_intersect.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "intersection/exact_orientation.hpp"

namespace gvd {
namespace {

Vec2 drop_axis(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// For c on the line from a to b, or anywhere where a == b.
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

/// Segments in one plane meet exactly where their projections along all three axes do. At least one projection maps the
/// plane, or the common line, one to one.
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

/// For a segment in the triangle's plane, and for any segment where the triangle is degenerate.
bool flat_segment_meets(const Vec3& p, const Vec3& q, const Triangle& triangle) {
  const auto flat = project(triangle);
  if (flat && contains(*flat, drop_axis(p, flat->axis))) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segments_meet(p, q, triangle[i], triangle[(i + 1) % 3])) return true;
  }
  return false;
}

/// Whether all of the points lie strictly on one side of the triangle's plane.
bool lie_beside(const Triangle& triangle, const std::vector<Vec3>& points) {
  const auto side = [&](const Vec3& p) { return exact_orientation(triangle[0], triangle[1], triangle[2], p); };
  const int first = side(points.front());
  return first != 0 && std::all_of(points.begin() + 1, points.end(), [&](const Vec3& p) { return side(p) == first; });
}

Triangle corners(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

/// The corners of f that are no corners of g.
std::vector<Vec3> own_corners(const Mesh& mesh, FaceId f, FaceId g) {
  std::vector<Vec3> own;
  const auto& others = mesh.vertices(g);
  for (const VertexId v : mesh.vertices(f)) {
    if (std::find(others.begin(), others.end(), v) == others.end()) own.push_back(mesh.position(v));
  }
  return own;
}

/// Of two faces with a common edge: whether they lie in one plane, on the same side of it.
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

bool faces_intersect(const Mesh& mesh, FaceId f, FaceId g) {
  const Triangle first = corners(mesh, f), second = corners(mesh, g);
  const std::vector<Vec3> of_first = own_corners(mesh, f, g), of_second = own_corners(mesh, g, f);
  if (of_first.empty()) return true;
  if (of_first.size() == 1) return are_folded(first, of_first[0], of_second[0]);
  if (lie_beside(first, of_second) || lie_beside(second, of_first)) return false;
  if (of_first.size() == 3) return any_edge_meets(first, second) || any_edge_meets(second, first);
  return segment_meets_triangle(of_first[0], of_first[1], second) ||
         segment_meets_triangle(of_second[0], of_second[1], first);
}

}  // namespace gvd
