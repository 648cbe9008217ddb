#pragma once

#include <array>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A sum of doubles without rounding. Exact unless a product underflows or overflows.
class Expansion {
 public:
  /// Cost: O(components), of which there are at most as many as calls.
  void add(double value);

  /// Adds a product of differences, each the sum of two doubles (see exact_difference).
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b);
  void add_product(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);

  /// -1, 0 or 1.
  int sign() const;

 private:
  std::vector<double> components_;  // not 0, no two overlap, ascending by magnitude
};

/// a - b as the sum of two doubles: the rounded difference and its error.
std::array<double, 2> exact_difference(double a, double b);

/// -x.
inline std::array<double, 2> negated(const std::array<double, 2>& x) { return {-x[0], -x[1]}; }

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 on the line. Exact.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The side of the plane through a, b and c on which d lies. 1: a, b and c appear counter-clockwise from d; -1: the
/// other side; 0: in the plane, or a, b and c lie on a line. Exact, unless a product underflows.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

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

/// Whether a closed segment and a closed triangle have a common point. Exact; either may be degenerate.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& triangle);

/// Whether two different faces have a common point outside of the vertex or edge that they share. Exact.
///
/// Two faces of one edge intersect only where they are folded flat onto each other. Two faces of one vertex intersect
/// where the opposite edge of one meets the other. Why: the common points of two faces are convex and hold the vertex,
/// so they end on one of these edges. Two faces of the same three vertices intersect.
bool faces_intersect(const PlacedFaces& faces, FaceId f, FaceId g);

}  // namespace gvd
