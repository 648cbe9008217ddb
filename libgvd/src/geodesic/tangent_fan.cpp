// The tangent plane of a surface point.
//
// Idea: round a vertex the angles of the corners follow each other. If they don't add up to 2 pi, one factor scales
// them all, so that every direction has an opposite direction. Inside a face and on an edge the factor is 1.
// Source: Polthier and Schmies, Straightest geodesics on polyhedral surfaces, 1998.
// Invariant: the sectors of a tangent plane follow each other counter-clockwise from tangent angle 0, without gaps, and
// have the widths of their faces' corners times `scale_`.
#include "geodesic/tangent_fan.hpp"

#include <algorithm>
#include <numbers>

#include "geodesic/face_layout.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr double kPi = std::numbers::pi;

/// A direction this close to the boundary counts as one along it. Radians: a million times the rounding of an angle.
constexpr double kAlongBoundary = 1e-9;

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

}  // namespace gvd
