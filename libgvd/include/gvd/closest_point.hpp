#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

struct ClosestPoint {
  SurfacePoint point;
  double distance = 0;  ///< Euclidean, to the query, in mesh units
};

/// The point of face f that is closest to `query`. The face may have no area. Cost: O(1).
ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query);

/// Finds the closest point of a mesh: a tree of bounding boxes, split at the median of the longest axis.
///
/// Refers to the mesh, which must outlive it. Properties: (1) the distance is that of the best face of all, within
/// rounding; (2) among faces at the same distance the smallest id wins.
/// Cost: O(n log n) to build, O(log n) a query near the surface; 50 bytes a face.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const Mesh& mesh);

  /// Throws Error{precondition} where `query` is so large, or not finite, that no distance is finite.
  ClosestPoint query(const Vec3& query) const;

 private:
  struct Node {
    Vec3 low, high;
    std::int32_t first = 0;  ///< into faces_
    std::int32_t count = 0;
    std::int32_t right = -1;  ///< second child; the first one follows its parent; -1 in a leaf
  };

  void build(std::int32_t first, std::int32_t count, const std::vector<Vec3>& centres);
  void visit(std::int32_t index, const Vec3& query, ClosestPoint& best) const;

  const Mesh* mesh_;
  std::vector<FaceId> faces_;
  std::vector<Node> nodes_;
};

}  // namespace gvd
