#pragma once

#include <algorithm>
#include <cstdint>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window.hpp"

namespace gvd {

/// An angle by its cosine and sine.
struct Rotation {
  double cosine = 1, sine = 0;

  friend Rotation operator+(const Rotation& a, const Rotation& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }
  friend Rotation operator-(const Rotation& a, const Rotation& b) {
    return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
  }
  /// Whether this is no turn but for kGrazingAngle, or one to the other side. For angles in (-pi, pi].
  bool is_grazing() const { return sine < kGrazingAngle && cosine > 0; }
};

/// A direction at a vertex: in the face of `halfedge`, which leaves the vertex, at an angle in [0, that of the corner]
/// counter-clockwise from it.
struct FanRay {
  std::int32_t halfedge = -1;
  Rotation angle;

  bool valid() const { return halfedge >= 0; }
};

/// The faces round a vertex, one after the other.
///
/// The saddle fan rule: a shortest path that arrives at a pseudo-source goes on with an angle of at least pi on both
/// sides. With less on one side it would be shorter to cut the corner there, through flat faces. So with the total
/// angle theta, a path that arrives from direction phi goes on into [phi + pi, phi + theta - pi] and nowhere else; at a
/// boundary vertex, where one of the two sides is no surface, into [phi + pi, theta] and [0, phi - pi].
class VertexFan {
 public:
  explicit VertexFan(const FaceFrames& frames) : frames_(frames) {}

  const FaceFrame& face(std::int32_t h) const { return frames_.frame[FaceId(h / 3)]; }
  std::int32_t twin(std::int32_t h) const { return face(h).twin[static_cast<std::size_t>(h % 3)]; }

  /// The outgoing halfedge of the next face counter-clockwise, or -1.
  std::int32_t left_of(std::int32_t outgoing) const { return twin(previous(outgoing)); }
  /// The outgoing halfedge of the next face clockwise, or -1.
  std::int32_t right_of(std::int32_t outgoing) const {
    const std::int32_t across = twin(outgoing);
    return across < 0 ? -1 : next(across);
  }
  Rotation corner(std::int32_t outgoing) const {
    const auto i = static_cast<std::size_t>(outgoing % 3);
    return {face(outgoing).cosine[i], face(outgoing).sine[i]};
  }

  /// The direction at an angle of pi counter-clockwise from the ray; invalid where the boundary comes first, or the
  /// ray.
  FanRay straight_left(const FanRay& ray) const {
    Rotation turned = inside(corner(ray.halfedge) - ray.angle);
    for (std::int32_t h = left_of(ray.halfedge); h >= 0 && h != ray.halfedge; h = left_of(h)) {
      const Rotation after = turned + corner(h);
      // A corner is less than pi, so the sine changes its sign where the sum passes pi.
      if (after.sine < 0) return {h, {-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }
  /// The same clockwise.
  FanRay straight_right(const FanRay& ray) const {
    Rotation turned = inside(ray.angle);
    for (std::int32_t h = right_of(ray.halfedge); h >= 0 && h != ray.halfedge; h = right_of(h)) {
      const Rotation after = turned + corner(h);
      if (after.sine < 0) return {h, corner(h) - Rotation{-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }

 private:
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// A ray that was accepted although it only grazes its face lies outside of it by up to kGrazingAngle.
  static Rotation inside(const Rotation& r) { return r.sine >= 0 ? r : Rotation{r.cosine > 0 ? 1.0 : -1.0, 0}; }

  const FaceFrames& frames_;
};

/// The window that a vertex sends across the face of its corner c to the opposite side, between the rays `first` and
/// `last`, counter-clockwise; null stands for a side of the face.
inline Rays send_rays(const FaceFrame& f, std::size_t c, const Rotation* first, const Rotation* last) {
  const std::size_t p = (c + 1) % 3, q = (c + 2) % 3;
  const double length = f.length[p];
  // Law of sines in the triangle of the vertex, p and the point where the ray meets the side; the frame's origin is q.
  const auto position = [&](const Rotation& ray) {
    const double from_p = f.length[c] * ray.sine / (ray.sine * f.cosine[p] + ray.cosine * f.sine[p]);
    return std::clamp(length - from_p, 0.0, length);
  };
  return {last ? position(*last) : 0, first ? position(*first) : length, f.length[q] * f.cosine[q],
          f.length[q] * f.sine[q]};
}

}  // namespace gvd
