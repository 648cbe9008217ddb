#pragma once

#include <optional>

#include "geodesic/field/face_layout.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The position of a surface point in the layout of face f, whichever face the point names. Without a value if f does
/// not contain the point.
inline std::optional<Vec2> locate_in_face(const Mesh& mesh, FaceId f, const SurfacePoint& point) {
  const FaceLayout layout(mesh, f);
  if (point.face == f) return layout.at(point.bary);
  Vec2 at = Vec2::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.bary[i] == 0) continue;
    std::size_t k = 0;
    while (k < 3 && mesh.vertices(f)[k] != mesh.vertices(point.face)[i]) ++k;
    if (k == 3) return std::nullopt;
    at += point.bary[i] * layout.corner[k];
  }
  return at;
}

}  // namespace gvd
