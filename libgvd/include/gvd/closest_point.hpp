#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

struct ClosestPoint {
  SurfacePoint point;
  double distance = 0;  ///< Euclidean, to the query, in mesh units
};

/// The foot of a point on the line of a halfedge: 0 at the halfedge's start, 1 at its end. Not limited to the edge, and
/// not finite where the edge has no length. Cost: O(1).
inline double foot_on_edge(const Mesh& mesh, HalfedgeId h, const Vec3& point) {
  return foot_on_line(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), point);
}

/// The faces of the connected part of the surface around a point that is within a Euclidean distance of it; always
/// those of `faces_around`. The two banks of a slit, or two sheets that touch, are different parts. Mesh units.
/// Cost: O(k log k) for k faces.
std::vector<FaceId> faces_within(const Mesh& mesh, const SurfacePoint& point, double radius);

/// The point of face f that is closest to `query`. The face may have no area. Cost: O(1).
ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query);

struct NearestFace {
  FaceId face;
  double distance = 0;  ///< Euclidean, to the query, in mesh units
};

/// Finds closest points of a mesh: a tree of bounding boxes, split at the median of the longest axis.
///
/// Refers to the mesh, which must outlive it. Cost: O(n log n) to build, O(log n) a query near the surface; 170 bytes a
/// face.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const Mesh& mesh);

  /// Properties: (1) the distance is that of the best face of all, within rounding; (2) among faces at the same distance
  /// the smallest id wins.
  /// Throws Error{precondition} where `query` is so large, or not finite, that no distance is finite.
  ClosestPoint query(const Vec3& query) const;

  /// The nearest face within rounding; among faces at the same distance any one. For measurements, as it is several
  /// times as fast as `query`. `guess`: any face; the search is short where it is near. It ends with a face that is no
  /// farther than `enough`, mesh units: a point of a fan of needles lies in the boxes of half of them, which otherwise
  /// are all looked at for a distance of 1e-17 instead of 1e-16. `query` must be finite, and the mesh must have a face.
  NearestFace nearest_face(const Vec3& query, FaceId guess = FaceId(0), double enough = 0) const;

  /// Distance from one face, mesh units, as nearest_face measures it. Cost: O(1).
  double distance(const Vec3& query, FaceId f) const { return std::sqrt(square_distance(triangle(f), query)); }

 private:
  /// A face from its corner 0, and the products of its sides.
  struct Triangle {
    Vec3 origin, u, v;
    double uu = 0, uv = 0, vv = 0;
  };
  struct Node {
    Eigen::AlignedBox3d box;
    std::int32_t first = 0;   ///< a leaf's first face, into faces_
    std::int32_t count = 0;   ///< of a leaf's faces; 0 for an inner node
    std::int32_t right = -1;  ///< second child of an inner node; the first one follows its parent
  };

  static double square_distance(const Triangle& triangle, const Vec3& query);
  const Triangle& triangle(FaceId f) const { return triangles_[place_[f]]; }
  Triangle make_triangle(FaceId f) const;
  void build(std::int32_t first, std::int32_t count, const std::vector<Vec3>& centres);
  std::array<std::pair<double, std::int32_t>, 2> children(std::int32_t index, const Vec3& query) const;
  template <class Best>
  void visit(std::int32_t index, const Vec3& query, double enough, Best& best) const;

  const Mesh* mesh_;
  std::vector<FaceId> faces_;             ///< in the order of the leaves
  std::vector<Triangle> triangles_;       ///< of faces_
  IdVector<FaceId, std::int32_t> place_;  ///< of a face in faces_
  std::vector<Node> nodes_;
};

}  // namespace gvd
