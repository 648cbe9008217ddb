#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/self_intersections.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// The tests of a dual's triangles, beside those of its topology (check_dual): flipped triangles, exact predicates, and
// pairs of triangles that intersect.

namespace gvd {

using Triangle = std::array<Vec3, 3>;

/// The faces of a mesh with its vertices at these positions, which may be others than its own. Refers to both.
struct PlacedFaces {
  PlacedFaces(const Mesh& faces) : PlacedFaces(faces, faces.positions()) {}  // NOLINT: a mesh is one
  PlacedFaces(const Mesh& faces, const std::vector<Vec3>& at) : mesh(faces), positions(at) {}

  Triangle corners(FaceId f) const {
    const auto& [a, b, c] = mesh.vertices(f);
    return {positions[a.index()], positions[b.index()], positions[c.index()]};
  }

  const Mesh& mesh;
  const std::vector<Vec3>& positions;
};

// dual.cpp

/// Whether a triangle is degenerate, or flipped against a normal of any length: see kFlipTolerance. Cost: O(1).
bool is_flipped(const Triangle& triangle, const Vec3& normal);

/// The sum of the surface's unit normals at the three generators and the branch point of each face of a remesh.
std::vector<Vec3> normals_at_faces(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                   const std::vector<SurfacePoint>& face_points);

/// A triangle of a dual, by index, as a defect. `what` follows "the triangle of the generators a, b and c".
DualDefect triangle_defect(const Diagram& diagram, const DualMesh& dual, std::size_t triangle, const std::string& what,
                           DualProperty property = DualProperty::not_flipped);

// self_intersections.cpp

/// A sum of doubles without rounding. Exact unless a product underflows or overflows.
class Expansion {
 public:
  /// Cost: O(components), of which there are at most as many as calls.
  void add(double value);

  /// Adds a product of differences, each the sum of two doubles (see exact_difference).
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);

  /// -1, 0 or 1.
  int sign() const {
    if (components_.empty()) return 0;
    return components_.back() > 0 ? 1 : -1;
  }

 private:
  std::vector<double> components_;  // not 0, no two overlap, ascending by magnitude
};

/// a - b as the sum of two doubles: the rounded difference and its error.
std::array<double, 2> exact_difference(double a, double b);

inline std::array<double, 2> negated(const std::array<double, 2>& x) { return {-x[0], -x[1]}; }

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 on the line. Exact.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The side of the plane through a, b and c on which d lies. 1: a, b and c appear counter-clockwise from d; -1: the
/// other side; 0: in the plane, or a, b and c lie on a line. Exact, unless a product underflows.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether a closed segment and a closed triangle have a common point. Exact; either may be degenerate.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& triangle);

/// Whether two different faces have a common point outside of the vertex or edge that they share. Exact.
///
/// Two faces of one edge intersect only where they are folded flat onto each other. Two faces of one vertex intersect
/// where the opposite edge of one meets the other. Why: the common points of two faces are convex and hold the vertex,
/// so they end on one of these edges. Two faces of the same three vertices intersect.
bool faces_intersect(const PlacedFaces& faces, FaceId f, FaceId g);

/// A closed box whose sides are parallel to the axes, mesh units.
using Box3 = Eigen::AlignedBox3d;

/// The bounding box of a face, without rounding.
inline Box3 face_box(const PlacedFaces& faces, FaceId f) {
  const Triangle t = faces.corners(f);
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

/// A balanced tree of the bounding boxes of faces.
class FaceBoxes {
 public:
  /// The boxes of these faces, each listed once. Cost: O(k log k) for k of them.
  template <class Faces>
  FaceBoxes(const PlacedFaces& placed, const Faces& faces) {
    std::vector<Entry> entries;
    for (const FaceId f : faces) entries.push_back({face_box(placed, f), f});
    tree_.init(entries.begin(), entries.end());
  }

  /// Whether holds(f) is true of a face whose box overlaps this one; the first one ends the search.
  /// Cost: O(log n) and O(1) a call, as a rule.
  template <class Holds>
  bool any_of(const Box3& box, const Holds& holds) const {
    Search<Holds> search{box, holds};
    Eigen::BVIntersect(tree_, search);
    return search.found;
  }

 private:
  struct Entry {
    Box3 box;
    FaceId face;

    friend Box3 bounding_box(const Entry& entry) { return entry.box; }
  };

  /// The query that Eigen's tree runs.
  template <class Holds>
  struct Search {
    const Box3& box;
    const Holds& holds;
    bool found = false;

    bool intersectVolume(const Box3& volume) const { return volume.intersects(box); }
    bool intersectObject(const Entry& entry) { return found = entry.box.intersects(box) && holds(entry.face); }
  };

  Eigen::KdBVH<double, 3, Entry> tree_;
};

/// find_self_intersections for a mesh whose vertices have moved.
std::vector<FacePair> find_self_intersections(const PlacedFaces& faces, int threads, const Progress& progress = {});

}  // namespace gvd
