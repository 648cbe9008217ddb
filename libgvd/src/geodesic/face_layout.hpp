#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "base/barycentric.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A face laid out in the plane: corner 0 at the origin, corner 1 on the positive x axis, corner 2 above it. Mesh
/// units.
struct FaceLayout {
  std::array<Vec2, 3> corner;
  double twice_area;  ///< > 0

  /// Least height of the layout, relative to the longest edge; faces without area get it. It changes lengths by at most
  /// 1e-12 of themselves, and keeps the rate of barycentric coordinates below 1e12 per edge length.
  static constexpr double kLeastHeight = 1e-12;

  FaceLayout(const Mesh& mesh, FaceId f) {
    const auto& [l0, l1, l2] = mesh.shape(f).length;
    // This uses the vectors of the sides, because the law of cosines loses digits if side 0 is much shorter than the
    // others.
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3 base = mesh.position(b) - mesh.position(a), side = mesh.position(c) - mesh.position(a);
    const double height = std::max(mesh.shape(f).twice_area / l0, kLeastHeight * std::max({l0, l1, l2}));
    corner = {Vec2(0, 0), Vec2(l0, 0), Vec2(base.dot(side) / l0, height)};
    twice_area = l0 * height;
  }

  Vec2 at(const Bary& bary) const { return interpolate(bary, corner[0], corner[1], corner[2]); }
  /// Barycentric coordinates of a point of the plane.
  Bary bary(const Vec2& p) const {
    const Vec2 d = p - corner[0];
    const double v = cross(d, corner[2] - corner[0]) / twice_area, w = cross(corner[1] - corner[0], d) / twice_area;
    return {1 - v - w, v, w};
  }
  /// Unit vector from corner i to the next one.
  Vec2 side(int i) const { return (corner[(i + 1) % 3] - corner[i]).normalized(); }
  /// Derivative of the barycentric coordinates in a direction, per mesh unit.
  Bary bary_rate(const Vec2& direction) const {
    Bary rate{};
    for (std::size_t i = 0; i < 3; ++i) {
      rate[i] = cross(corner[(i + 2) % 3] - corner[(i + 1) % 3], direction) / twice_area;
    }
    return rate;
  }
};

/// The position of a surface point in the layout of face f, whichever face the point names. Without a value if f does
/// not contain the point.
inline std::optional<Vec2> locate_in_face(const Mesh& mesh, FaceId f, const SurfacePoint& point) {
  const FaceLayout layout(mesh, f);
  if (point.face == f) return layout.at(point.bary);
  const auto& corners = mesh.vertices(f);
  Vec2 at = Vec2::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.bary[i] == 0) continue;
    const auto found = std::find(corners.begin(), corners.end(), mesh.vertices(point.face)[i]);
    if (found == corners.end()) return std::nullopt;
    at += point.bary[i] * layout.corner[found - corners.begin()];
  }
  return at;
}

}  // namespace gvd
