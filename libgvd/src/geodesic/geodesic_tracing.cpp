// The exponential map, straight lines on the surface, and the tangent planes in which they begin.
//
// Idea: a line is straight in the plane of its face. At an edge, the next face is unfolded into that plane, so the line
// keeps its angle with the edge. At a vertex it continues with equal angles on both sides. Round a vertex the angles of
// the corners follow each other. Where they do not add up to 2 pi, one factor scales them all, so that a direction has
// an opposite one. Inside a face and on an edge the factor is 1.
// Source: Polthier and Schmies, Straightest geodesics on polyhedral surfaces, 1998.
// Invariant: the current point lies in its face, the direction is a unit vector in that face's layout, and the line
// never leaves through a side that contains the point. The sectors of a tangent plane follow each other
// counter-clockwise from tangent angle 0, without gaps, and have the widths of their faces' corners times `scale_`.
#include "gvd/geodesic_tracing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/barycentric.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr double kPi = std::numbers::pi;

/// A direction this close to the boundary counts as one along it. Radians: a million times the rounding of an angle.
constexpr double kAlongBoundary = 1e-9;

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

  /// Continues in the face of `point`. The line does not leave through a side that contains the point: only rounding
  /// makes the direction point out of it.
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

double normalized_angle(double angle) {
  const double turned = std::fmod(angle, 2 * kPi);
  const double positive = turned < 0 ? turned + 2 * kPi : turned;
  return positive < 2 * kPi ? positive : 0;  // the sum of a tiny negative angle and 2 pi rounds to 2 pi
}

TangentFan::TangentFan(const Mesh& mesh, const SurfacePoint& point) {
  if (point.kind() == SurfacePoint::Kind::vertex) {
    add_vertex(mesh, vertex(mesh, point));
  } else if (point.kind() == SurfacePoint::Kind::edge) {
    add_edge(mesh, point);
  } else {
    total_ = 2 * kPi;
    sectors_.push_back({point, 0, total_, Vec2(1, 0)});
  }
  for (const TangentSector& s : sectors_) by_face_.emplace_back(s.point.face, by_face_.size());
  std::ranges::sort(by_face_);
}

const TangentSector* TangentFan::sector_in(FaceId face) const {
  const auto found = std::ranges::lower_bound(by_face_, std::pair(face, std::size_t{0}));
  return found != by_face_.end() && found->first == face ? &sectors_[found->second] : nullptr;
}

void TangentFan::add_edge(const Mesh& mesh, const SurfacePoint& point) {
  const HalfedgeId h = halfedge(point), twin = mesh.twin(h);
  const int corner = Mesh::corner(h);
  sectors_.push_back({point, 0, kPi, FaceLayout(mesh, point.face).side(corner)});
  closed_ = twin.valid();
  total_ = closed_ ? 2 * kPi : kPi;
  if (!closed_) return;
  sectors_.push_back(
      {*find_view_across(mesh, point), kPi, kPi, FaceLayout(mesh, Mesh::face(twin)).side(Mesh::corner(twin))});
}

void TangentFan::add_vertex(const Mesh& mesh, VertexId v) {
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    const FaceLayout layout(mesh, Mesh::face(h));
    const int corner = Mesh::corner(h);
    const Vec2 first = layout.side(corner), last = -layout.side((corner + 2) % 3);
    const double width = std::atan2(std::abs(cross(first, last)), first.dot(last));
    sectors_.push_back({edge_point(h, 0), total_, width, first});
    total_ += width;
  });
  closed_ = !mesh.is_boundary(v);
  if (!closed_ && total_ <= 2 * kPi) return;
  scale_ = 2 * kPi / total_;
  total_ = 2 * kPi;
  for (TangentSector& s : sectors_) {
    s.begin *= scale_;
    s.width *= scale_;
  }
}

std::optional<FaceDirection> TangentFan::face_direction(double angle) const {
  angle = normalized_angle(angle);
  if (!closed_ && angle > total_) {
    if (angle >= 2 * kPi - kAlongBoundary) {
      angle = 0;
    } else if (angle <= total_ + kAlongBoundary) {
      angle = total_;
    } else {
      return std::nullopt;
    }
  }
  std::size_t i = sectors_.size() - 1;
  while (i > 0 && sectors_[i].begin > angle) --i;
  const TangentSector& s = sectors_[i];
  const Vec2 local = unit_vector(std::min(angle - s.begin, s.width) / scale_);
  return FaceDirection{s.point, local.x() * s.reference + local.y() * turned_left(s.reference)};
}

double TangentFan::angle(FaceId face, const Vec2& direction) const {
  const TangentSector* found = sector_in(face);
  const TangentSector& s = found != nullptr ? *found : sectors_.back();
  // Measured from the middle of the sector, so that rounding at a side of the sector can't change it by 2 pi.
  const Vec2 middle = unit_vector(0.5 * s.width / scale_);
  const Vec2 turned(direction.dot(s.reference), cross(s.reference, direction));
  const double offset = std::atan2(cross(middle, turned), middle.dot(turned));
  return normalized_angle(s.begin + 0.5 * s.width + scale_ * offset);
}

GeodesicTrace trace_geodesic(const Mesh& mesh, const SurfacePoint& start, const Vec2& tangent) {
  if (!start.face.valid() || start.face.value() >= mesh.face_count()) {
    throw Error(ErrorCode::precondition,
                fmt::format("a geodesic can't start in face {}: the mesh has {}", start.face.value(),
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
