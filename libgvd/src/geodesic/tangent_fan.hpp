#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The sector of a point's tangent plane that lies in one face.
struct TangentSector {
  SurfacePoint point;  ///< the fan's point, given in this face
  double begin;        ///< tangent angle of its first side, radians
  double width;        ///< tangent angle between its sides, radians
  Vec2 reference;      ///< its first side, a unit vector in the face's layout
};

/// A direction in a face's layout.
struct FaceDirection {
  SurfacePoint point;
  Vec2 direction;  ///< unit
};

/// The faces round a surface point, and their sectors of its tangent plane (see geodesic_tracing.hpp).
class TangentFan {
 public:
  /// Cost: O(degree of the vertex), and sorting its faces.
  TangentFan(const Mesh& mesh, const SurfacePoint& point);

  const std::vector<TangentSector>& sectors() const { return sectors_; }
  /// Whether the sectors cover all directions: the point is not on the boundary.
  bool closed() const { return closed_; }
  /// The angle that the sectors cover, radians; 2 pi if closed.
  double total() const { return total_; }
  /// Ratio of tangent angles to angles on the surface: 1 except at a vertex.
  double scale() const { return scale_; }

  /// The sector in a face; null if there is none. Cost: O(log degree).
  const TangentSector* sector_in(FaceId face) const;
  /// The face and direction of a tangent angle. Without a value if it leads off the surface.
  std::optional<FaceDirection> face_direction(double angle) const;
  /// The tangent angle, in [0, 2 pi), of a direction in the layout of one of the fan's faces.
  double angle(FaceId face, const Vec2& direction) const;

 private:
  void add_edge(const Mesh& mesh, const SurfacePoint& point);
  void add_vertex(const Mesh& mesh, VertexId v);

  std::vector<TangentSector> sectors_;
  std::vector<std::pair<FaceId, std::size_t>> by_face_;  // ascending; indices of sectors
  double scale_ = 1;                                     // ratio of tangent angles to angles on the surface
  double total_ = 0;
  bool closed_ = true;
};

/// The equivalent angle in [0, 2 pi), radians.
double normalized_angle(double angle);
inline double angle_of(const Vec2& v) { return normalized_angle(std::atan2(v.y(), v.x())); }

}  // namespace gvd
