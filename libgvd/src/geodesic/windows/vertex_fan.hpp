#pragma once

#include <algorithm>
#include <cstddef>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_geometry.hpp"

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
  /// Whether this angle, in (-pi, pi], is negative, or zero up to kGrazingAngle.
  bool is_grazing() const { return sine < kGrazingAngle && cosine > 0; }
};

/// A direction at a vertex. It lies in the face of `halfedge`, which leaves the vertex, at an angle counter-clockwise
/// from that halfedge that is at most the angle of the corner.
struct FanRay {
  HalfedgeId halfedge;
  Rotation angle;

  bool valid() const { return halfedge.valid(); }
};

struct VertexPath {
  double distance;  ///< length from the generator, mesh units
  GeneratorId generator;
  FanRay back;               ///< direction at the vertex from which the path comes; invalid at a generator
  Departure departure = {};  ///< direction in which it leaves the generator, if departures are recorded
};

/// The faces round a vertex, one after the other.
///
/// The saddle fan rule: a shortest path that passes through a pseudo-source leaves an angle of at least pi on both
/// sides. If the angle on one side were smaller, a path that cuts the corner there would be shorter. With the total
/// angle theta, a path that arrives from direction phi therefore continues only into [phi + pi, phi + theta - pi]. At a
/// boundary vertex, one of the two sides is not part of the surface, and the path continues into [phi + pi, theta] and
/// [0, phi - pi].
class VertexFan {
 public:
  explicit VertexFan(const FaceFrames& frames) : frames_(frames) {}

  const FaceFrame& face(HalfedgeId h) const { return frames_.frame[Mesh::face(h)]; }
  HalfedgeId twin(HalfedgeId h) const { return face(h).twin[corner_index(h)]; }

  /// The outgoing halfedge of the next face counter-clockwise; invalid at the boundary.
  HalfedgeId left_of(HalfedgeId outgoing) const { return twin(Mesh::previous(outgoing)); }
  /// The outgoing halfedge of the next face clockwise; invalid at the boundary.
  HalfedgeId right_of(HalfedgeId outgoing) const {
    const HalfedgeId across = twin(outgoing);
    return across.valid() ? Mesh::next(across) : HalfedgeId();
  }
  Rotation corner(HalfedgeId outgoing) const {
    const std::size_t i = corner_index(outgoing);
    return {face(outgoing).cosine[i], face(outgoing).sine[i]};
  }

  /// The direction at an angle of pi counter-clockwise from the ray; invalid if the boundary or the ray comes first.
  FanRay straight_left(const FanRay& ray) const {
    Rotation turned = inside(corner(ray.halfedge) - ray.angle);
    for (HalfedgeId h = left_of(ray.halfedge); h.valid() && h != ray.halfedge; h = left_of(h)) {
      const Rotation after = turned + corner(h);
      // The angle of a corner is less than pi, so the sine changes its sign when the sum passes pi.
      if (after.sine < 0) return {h, {-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }
  /// The same clockwise.
  FanRay straight_right(const FanRay& ray) const {
    Rotation turned = inside(ray.angle);
    for (HalfedgeId h = right_of(ray.halfedge); h.valid() && h != ray.halfedge; h = right_of(h)) {
      const Rotation after = turned + corner(h);
      if (after.sine < 0) return {h, corner(h) - Rotation{-turned.cosine, turned.sine}};
      turned = after;
    }
    return {};
  }

 private:
  static std::size_t corner_index(HalfedgeId h) { return Mesh::corner(h); }
  /// Clamps an angle to >= 0. A ray that was accepted because it grazes its face may lie outside the face by up to
  /// kGrazingAngle.
  static Rotation inside(const Rotation& r) { return r.sine >= 0 ? r : Rotation{r.cosine > 0 ? 1.0 : -1.0, 0}; }

  const FaceFrames& frames_;
};

/// The part of a face's corner that lies between two rays, counter-clockwise. Null stands for a side of the face.
struct FanSector {
  HalfedgeId outgoing;  ///< halfedge of the face that leaves the vertex
  const Rotation* first;
  const Rotation* last;
};

/// The window that a vertex sends through a sector of face f to the opposite side. `path` is the path to the vertex.
inline Window window_from_vertex(const FaceFrame& f, const FanSector& sector, const VertexPath& path) {
  const std::size_t c = Mesh::corner(sector.outgoing), p = (c + 1) % 3, q = (c + 2) % 3;
  const double length = f.length[p];
  // Law of sines in the triangle of the vertex, p and the point where the ray meets the side; the frame's origin is q.
  const auto position = [&](const Rotation& ray) {
    const double from_p = f.length[c] * ray.sine / (ray.sine * f.cosine[p] + ray.cosine * f.sine[p]);
    return std::clamp(length - from_p, 0.0, length);
  };
  return {sector.last ? position(*sector.last) : 0,
          sector.first ? position(*sector.first) : length,
          f.length[q] * f.cosine[q],
          f.length[q] * f.sine[q],
          path.distance,
          path.generator,
          f.twin[p]};
}

}  // namespace gvd
