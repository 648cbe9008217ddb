#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/remesh_certificate.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The faces of a mesh with other vertex positions. Throws Error{precondition} if an edge has no length.
Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions);

/// Moves the vertices of a remesh as far as its triangles stay valid.
class MoveGuard {
 public:
  /// `remesh` has its vertices at the generators. The guard ignores defects that are there already. Both meshes must
  /// outlive it.
  MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
            const std::vector<SurfacePoint>& face_points, const PlacementOptions& options);

  /// Allows angles down to `least_angle`, in degrees, in the triangles of these vertices, which have to meet creases.
  void loosen(const std::vector<char>& vertices, double least_angle);

  /// Moves the vertices from valid positions towards others. Steps are halved, and in the end left out, until all
  /// triangles are valid. All triangles are tested before any step is changed, so that the result is deterministic.
  /// Cost: O(n log n) for each test.
  std::vector<Vec3> move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const;

  /// The least angle that each triangle may have, degrees.
  const IdVector<FaceId, double>& least_angles() const { return least_angle_; }

  /// The normal of the surface at each triangle, of any length.
  const IdVector<FaceId, Vec3>& normals() const { return normal_; }

 private:
  bool is_bad(FaceId f, const std::vector<Vec3>& positions) const;
  std::vector<FaceId> find_bad_faces(const std::vector<Vec3>& positions) const;
  std::vector<FaceId> find_crossed_faces(const std::vector<Vec3>& positions) const;

  const Mesh& remesh_;
  int threads_;
  Progress progress_;
  IdVector<FaceId, Vec3> normal_;         // of the surface at each face
  IdVector<FaceId, double> least_angle_;  // that each face may have, degrees
  std::vector<FacePair> crossed_before_;
};

}  // namespace gvd
