// The exponential map: straight lines on the surface.
//
// Idea: a line is straight in the plane of its face. At an edge, the next face is unfolded into that plane, so the line
// keeps its angle with the edge. At a vertex it continues with equal angles on both sides.
// Source: Polthier and Schmies, Straightest geodesics on polyhedral surfaces, 1998.
// Invariant: the current point lies in its face, the direction is a unit vector in that face's layout, and the line
// never leaves through a side that contains the point.
#include "gvd/geodesic_tracing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "base/barycentric.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

class GeodesicWalker {
 public:
  GeodesicWalker(const Mesh& mesh, const SurfacePoint& start, const Vec2& tangent)
      : mesh_(mesh), left_(tangent.norm()) {
    trace_.points.push_back(start);
    if (left_ > 0) continue_along(TangentFan(mesh, start), std::atan2(tangent.y(), tangent.x()));
  }

  GeodesicTrace run() {
    const double wanted = left_;
    // A line of finite length crosses finitely many faces. The bound guards against cycles caused by rounding in thin
    // faces.
    const std::int64_t max_faces = 1000 + 100 * std::int64_t{mesh_.face_count()};
    for (std::int64_t i = 0; walking_ && i < max_faces; ++i) cross_face();
    trace_.length = wanted - left_;
    trace_.complete = left_ <= 0;
    return std::move(trace_);
  }

 private:
  /// Continues from the current point in the direction of a tangent angle.
  void continue_along(const TangentFan& fan, double angle) {
    trace_.direction = unit_vector(angle);
    const auto next = fan.face_direction(angle);
    walking_ = next.has_value();
    if (walking_) enter(next->point, next->direction);
  }

  /// Continues in the face of `point`. The line does not leave through a side that contains the point; if the direction
  /// points out of such a side, this is only by rounding.
  void enter(const SurfacePoint& point, const Vec2& direction) {
    point_ = point;
    direction_ = direction;
    for (std::size_t i = 0; i < 3; ++i) on_side_[i] = point.bary[i] == 0;
  }

  void cross_face() {
    const FaceLayout layout(mesh_, point_.face);
    const Bary rate = layout.bary_rate(direction_);
    double step = kInfinity;
    int side = 3;  // the side opposite to this corner; 3: none
    for (int i = 0; i < 3; ++i) {
      if (on_side_[i] || !(rate[i] < 0) || -point_.bary[i] / rate[i] >= step) continue;
      step = -point_.bary[i] / rate[i];
      side = i;
    }
    if (left_ <= step || side == 3) return end_inside(rate);
    left_ -= step;
    Bary bary = moved(rate, step);
    bary[side] = 0;
    leave(make_surface_point(point_.face, normalized(bary)), layout, side);
  }

  Bary moved(const Bary& rate, double step) const {
    Bary bary{};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool leaves = on_side_[i] && rate[i] <= 0;
      bary[i] = leaves ? 0 : std::max(0.0, point_.bary[i] + step * rate[i]);
    }
    return bary;
  }

  static Bary normalized(const Bary& bary) {
    const double sum = bary[0] + bary[1] + bary[2];
    return {bary[0] / sum, bary[1] / sum, bary[2] / sum};
  }

  void end_inside(const Bary& rate) {
    const SurfacePoint end = make_surface_point(point_.face, normalized(moved(rate, left_)));
    left_ = 0;
    walking_ = false;
    trace_.points.push_back(end);
    trace_.direction = unit_vector(TangentFan(mesh_, end).angle(end.face, direction_));
  }

  void leave(const SurfacePoint& exit, const FaceLayout& layout, int side) {
    trace_.points.push_back(exit);
    if (exit.kind() == SurfacePoint::Kind::vertex) return leave_through_vertex(exit);
    const HalfedgeId h = Mesh::next(Mesh::halfedge(point_.face, side)), twin = mesh_.twin(h);
    const Vec2 along = layout.side(Mesh::corner(h));
    const double forward = along.dot(direction_), inward = cross(along, direction_);
    if (!twin.valid()) {
      trace_.direction = Vec2(forward, inward);
      walking_ = false;
      return;
    }
    const Vec2 back = FaceLayout(mesh_, Mesh::face(twin)).side(Mesh::corner(twin));
    // The twin has the opposite direction, so both components change their sign.
    enter(*find_view_across(mesh_, exit), -forward * back - inward * turned_left(back));
  }

  void leave_through_vertex(const SurfacePoint& exit) {
    const TangentFan fan(mesh_, exit);
    const double onward = fan.angle(point_.face, -direction_) + std::numbers::pi;
    if (fan.closed()) return continue_along(fan, onward);
    trace_.direction = unit_vector(onward);
    walking_ = false;
  }

  const Mesh& mesh_;
  double left_;  // remaining length
  bool walking_ = false;
  SurfacePoint point_;
  Vec2 direction_ = Vec2::Zero();  // unit, in the layout of point_.face
  std::array<bool, 3> on_side_{};
  GeodesicTrace trace_;
};

}  // namespace

GeodesicTrace trace_geodesic(const Mesh& mesh, const SurfacePoint& start, const Vec2& tangent) {
  if (!start.face.valid() || start.face.value() >= mesh.face_count()) {
    throw Error(ErrorCode::precondition,
                fmt::format("there is no face {} to start a geodesic in; the mesh has {}", start.face.value(),
                            counted(mesh.face_count(), "face", "faces")),
                start.face.value());
  }
  if (!tangent.allFinite()) throw Error(ErrorCode::precondition, "a geodesic's tangent vector must be finite");
  return GeodesicWalker(mesh, start, tangent).run();
}

Vec2 project_to_surface(const Mesh& mesh, const SurfacePoint& point, const Vec2& tangent) {
  const TangentFan fan(mesh, point);
  const double angle = angle_of(tangent);
  if (fan.closed() || angle <= fan.total()) return tangent;
  // Off the surface: project to the nearer of the two directions along the boundary.
  const Vec2 first(1, 0), last = unit_vector(fan.total());
  const double along_first = tangent.dot(first), along_last = tangent.dot(last);
  if (along_first <= 0 && along_last <= 0) return Vec2::Zero();
  return along_first >= along_last ? Vec2(along_first * first) : Vec2(along_last * last);
}

}  // namespace gvd
