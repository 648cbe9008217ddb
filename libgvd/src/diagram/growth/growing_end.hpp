#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "base/plane.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "geodesic/marching/unfold.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The point where a growing end leaves its face.
struct Exit {
  HalfedgeId halfedge;
  double t;  ///< parameter along the halfedge
  Vec2 point;
  double distance;  ///< predicted, mesh units
};

/// The end of a bisector that grows through a face (section 4.3). Positions are in the plane of the face; an image is
/// the position of a generator that was unfolded into that plane.
struct GrowingEnd {
  FaceId face;
  int node;  ///< the node of the gap where it starts
  Vec2 start;
  GeneratorId left, right;
  Vec2 left_image, right_image;
  std::optional<Exit> exit{};  ///< its exit event, if it has one
  bool active = true;

  /// Unit vector along the bisector of the two images, with the left image on the left.
  Vec2 direction() const { return turned_left(right_image - left_image).normalized(); }

  /// Predicted distance of a point from the two generators: the mean of those to the images.
  double distance_at(const Vec2& p) const { return 0.5 * ((p - left_image).norm() + (p - right_image).norm()); }
};

/// The exit event of an end: the first edge through which its ray leaves the face with these corners. None if the ray
/// runs along an edge or away from the face, or has no direction.
inline std::optional<Exit> find_exit(const GrowingEnd& end, const std::array<Vec2, 3>& corner) {
  const Vec2 direction = end.direction();
  if (!direction.allFinite()) return std::nullopt;
  std::optional<Exit> first;
  double soonest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec2& a = corner[i];
    const Vec2 along = corner[(i + 1) % 3] - a;
    const double outward = cross(direction, along);  // > 0: the ray crosses this edge from inside to outside
    if (!(outward > 0)) continue;
    const double to_edge = std::max(0.0, intersect_lines(end.start, direction, a, along).s);
    if (to_edge >= soonest) continue;
    soonest = to_edge;
    const Vec2 point = end.start + to_edge * direction;
    first =
        Exit{Mesh::halfedge(end.face, i), (point - a).dot(along) / along.squaredNorm(), point, end.distance_at(point)};
  }
  return first;
}

/// The intersection of two ends in one face, if both reach it before they leave the face (section 4.3, intersection
/// computation). `first` is the left one of the two, so that the cell between them narrows towards the intersection.
inline std::optional<Vec2> find_intersection(const GrowingEnd& first, const GrowingEnd& second) {
  if (!first.exit || !second.exit) return std::nullopt;
  const Vec2 d = first.exit->point - first.start, e = second.exit->point - second.start;
  if (!(cross(d, e) > 0)) return std::nullopt;
  const auto [s, t] = intersect_lines(first.start, d, second.start, e);
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::nullopt;
  return first.start + s * d;
}

/// The rotation around an edge that takes the plane of one of its faces into the plane of the other (section 4.3).
class EdgeRotation {
 public:
  /// `a` and `b` are the ends of the edge in the old plane, `a_new` and `b_new` in the new one.
  EdgeRotation(const Vec2& a, const Vec2& b, const Vec2& a_new, const Vec2& b_new) : from_(a), to_(a_new) {
    const Vec2 u = (b - a).normalized(), v = (b_new - a_new).normalized();
    cosine_ = u.dot(v);
    sine_ = cross(u, v);
  }
  Vec2 operator()(const Vec2& p) const {
    const Vec2 d = p - from_;
    return to_ + Vec2(cosine_ * d.x() - sine_ * d.y(), sine_ * d.x() + cosine_ * d.y());
  }

 private:
  Vec2 from_, to_;
  double cosine_, sine_;
};

}  // namespace gvd
