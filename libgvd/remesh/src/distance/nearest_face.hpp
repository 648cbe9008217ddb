#pragma once

#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// The face of a mesh that is nearest to a point in space.
struct NearestFace {
  FaceId face;
  double distance = 0;  ///< mesh units
};

/// Finds nearest faces, for measurements: within rounding, and of faces at the same distance any one. Three times as
/// fast as ClosestPointTree.
class NearestFaceTree {
 public:
  /// Copies what it needs of the mesh, which must have a face. Cost: O(n log n).
  explicit NearestFaceTree(const Mesh& mesh);

  /// `guess`: any face; the search is short where it is near the point. `point` must be finite.
  /// Cost: O(log n) near the surface.
  NearestFace find(const Vec3& point, FaceId guess = FaceId(0)) const;

  /// Distance of a point from one face, mesh units. Cost: O(1).
  double distance(const Vec3& point, FaceId f) const;

 private:
  /// A face from its corner 0, and the products of its sides.
  struct Triangle {
    Vec3 origin, u, v;
    double uu = 0, uv = 0, vv = 0;
  };
  struct Node {
    Vec3 low, high;
    std::int32_t first = 0;   ///< a leaf's first face, into faces_
    std::int32_t count = 0;   ///< of a leaf's faces; 0 for an inner node
    std::int32_t right = -1;  ///< second child of an inner node; the first one follows its parent
  };

  static double square_distance(const Triangle& triangle, const Vec3& point);
  void build(const Mesh& mesh, std::int32_t first, std::int32_t count);
  void visit(std::int32_t index, const Vec3& point, NearestFace& best) const;

  IdVector<FaceId, Triangle> triangles_;
  std::vector<FaceId> faces_;
  std::vector<Node> nodes_;
};

}  // namespace gvd
