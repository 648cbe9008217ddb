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

/// The parameter of a point's foot on the line through a halfedge: 0 at the halfedge's start, 1 at its end. It is not
/// limited to [0, 1]. Cost: O(1).
inline double foot_on_edge(const Mesh& mesh, HalfedgeId h, const Vec3& point) {
  return foot_on_line(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), point);
}

/// Finds the faces that a walk from a point reaches if it crosses only edges within the Euclidean distance `radius`
/// (mesh units) of the point. The faces of `faces_around` come first. The walk does not cross a slit, or change from
/// one sheet of the surface to another that touches it. Cost: O(k log k) for k faces.
std::vector<FaceId> faces_within(const Mesh& mesh, const SurfacePoint& point, double radius);

/// The point of face f that is closest to `query`. The face may have no area. Cost: O(1).
ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query);

struct NearestFace {
  FaceId face;
  double distance = 0;  ///< Euclidean, to the query, in mesh units
};

/// Finds the point of a mesh that is closest to a query, with a tree of bounding boxes that are split at the median of
/// their longest axis. Needles are in it slice by slice.
///
/// The tree refers to the mesh, which must outlive it. Cost: O(n log n) to build, O(log n) for a query near the
/// surface; 180 bytes a face or slice of a needle, of which there are at most five times as many as faces.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const Mesh& mesh);

  /// Returns the point of the mesh that is closest to `query`, and its distance.
  /// Properties: (1) no face is nearer, within rounding; (2) among faces at the same distance, the one with the
  /// smallest id is chosen.
  /// Throws Error{precondition} if no distance is finite, because `query` is not finite or too large.
  ClosestPoint query(const Vec3& query) const;

  /// Returns the nearest face within rounding; if several faces are at the same distance, any one of them. This is
  /// several times as fast as `query`, and made for measurements. `guess` may be any face; the search is short if it is
  /// near. The search stops at a face that is no farther than `enough` (mesh units): a point of a fan of needles lies
  /// in the boxes of half of them, and without it all of these are tried for a distance of 1e-17 instead of 1e-16.
  /// `query` must be finite, and the mesh must have a face.
  NearestFace nearest_face(const Vec3& query, FaceId guess = FaceId(0), double enough = 0) const;

  /// The distance of `query` from face f in mesh units, as nearest_face measures it. Cost: O(1).
  double distance(const Vec3& query, FaceId f) const { return std::sqrt(square_distance(triangle(f), query)); }

 private:
  /// A face as a corner and the two sides that leave it, with the products of these sides.
  struct Triangle {
    Vec3 origin, u, v;
    double uu = 0, uv = 0, vv = 0;
    double determinant = 0;  ///< uu vv - uv^2; 0 for a thin triangle, where that is mostly rounding
  };
  /// A query, also along the axes of the boxes.
  struct Place {
    const Vec3& query;
    Vec3 turned;
  };
  class Entries;
  struct Node {
    Eigen::AlignedBox3d box;
    std::int32_t first = 0;   ///< index in faces_ of a leaf's first entry
    std::int32_t count = 0;   ///< number of a leaf's entries; 0 for an inner node
    std::int32_t right = -1;  ///< second child of an inner node; the first child follows its parent
  };

  static double square_distance(const Triangle& triangle, const Vec3& query);
  const Triangle& triangle(FaceId f) const { return triangles_[place_[f]]; }
  Triangle make_triangle(FaceId f) const;
  void build(std::int32_t first, std::int32_t count, Entries& entries);
  std::array<std::pair<double, std::int32_t>, 2> children(std::int32_t index, const Vec3& turned) const;
  template <class Best>
  void visit(std::int32_t index, const Place& at, double enough, Best& best) const;

  const Mesh* mesh_;
  bool is_turned_ = false;                ///< whether the axes differ from those of the coordinates
  Eigen::Matrix3d axes_;                  ///< that the boxes follow, as rows
  std::vector<FaceId> faces_;             ///< of the entries, in the order of the leaves; a needle has several
  std::vector<Triangle> triangles_;       ///< in the order of faces_
  IdVector<FaceId, std::int32_t> place_;  ///< index in faces_ of an entry of each face
  std::vector<Node> nodes_;
};

}  // namespace gvd
