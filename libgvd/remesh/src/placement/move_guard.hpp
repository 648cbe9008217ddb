#pragma once

#include <array>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/self_intersections.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Moves the vertices of a remesh as far as its triangles stay valid.
class MoveGuard {
 public:
  /// `remesh` has its vertices at the generators. What is wrong with it already is no concern of the guard. Both
  /// meshes must outlive it.
  MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
            const std::vector<SurfacePoint>& face_points, const PlacementOptions& options);

  /// Lets the triangles of these vertices have angles down to `least_angle`, degrees: they have to meet creases.
  void loosen(const std::vector<char>& vertices, double least_angle);

  /// The steps from one valid list of positions to another, each halved until all triangles are valid, or left out.
  /// Deterministic: all triangles are tested, then all steps are changed. Cost: O(n log n) a test.
  std::vector<Vec3> move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const;

 private:
  using Corners = std::array<Vec3, 3>;
  Corners corners(FaceId f, const std::vector<Vec3>& positions) const;
  bool is_bad(FaceId f, const Corners& corners) const;
  std::vector<FaceId> find_bad_faces(const std::vector<Vec3>& positions) const;
  std::vector<FaceId> find_crossed_faces(const std::vector<Vec3>& positions) const;

  const Mesh& remesh_;
  int threads_;
  IdVector<FaceId, Vec3> normal_;         // of the surface at each face
  IdVector<FaceId, double> least_angle_;  // that each face may have, degrees
  std::vector<FacePair> crossed_before_;
};

}  // namespace gvd
