#pragma once

#include <algorithm>
#include <cstdint>

#include "geodesic/face_frames.hpp"

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
};

/// A direction at a vertex: in the face of `halfedge`, which leaves the vertex, at an angle in [0, that of the corner]
/// counter-clockwise from it.
struct FanRay {
  std::int32_t halfedge = -1;
  Rotation angle;

  bool valid() const { return halfedge >= 0; }
};

/// The faces round a vertex, from one to the next.
class VertexFan {
 public:
  explicit VertexFan(const FaceFrames& frames) : frames_(frames) {}

  const FaceFrame& face(std::int32_t h) const { return frames_.frame[FaceId(h / 3)]; }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
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

  /// The direction at an angle of pi counter-clockwise from the ray; invalid where the boundary comes first.
  FanRay straight_left(const FanRay& ray) const {
    Rotation turned = positive(corner(ray.halfedge) - ray.angle);
    for (std::int32_t h = left_of(ray.halfedge); h >= 0; h = left_of(h)) {
      const Rotation after = turned + corner(h);
      // A corner is less than pi, so the sine changes its sign where the sum passes pi.
      if (after.sine < 0) return {h, {-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }
  /// The same clockwise.
  FanRay straight_right(const FanRay& ray) const {
    Rotation turned = positive(ray.angle);
    for (std::int32_t h = right_of(ray.halfedge); h >= 0; h = right_of(h)) {
      const Rotation after = turned + corner(h);
      if (after.sine < 0) return {h, corner(h) - Rotation{-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }

 private:
  /// A ray accepted for grazing may lie outside of its face by rounding.
  static Rotation positive(const Rotation& r) { return r.sine >= 0 ? r : Rotation{r.cosine > 0 ? 1.0 : -1.0, 0}; }

  const FaceFrames& frames_;
};

}  // namespace gvd
