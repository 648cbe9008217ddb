#pragma once

#include <cstdint>

#include "gvd/mesh.hpp"

namespace gvd {

/// Shape figures of a mesh's triangles, as section 5 of the paper tabulates them for remeshes.
struct TriangleQuality {
  double q_min = 0;              ///< least Q, in [0, 1]
  double q_average = 0;          ///< mean Q over the triangles, in [0, 1]
  double angle_min = 0;          ///< least angle of all triangles, degrees in [0, 60]
  double angle_min_average = 0;  ///< mean over the triangles of their least angle, degrees in [0, 60]
  double percent_below_30 = 0;   ///< triangles with an angle below 30 degrees, percent in [0, 100]
};

/// Q = 6 / sqrt(3) * S / (p h) of the triangle a b c with area S, half perimeter p and longest edge h.
///
/// Inputs:  positions in mesh units
/// Returns: dimensionless, in [0, 1]
/// Properties: (1) 1 for the equilateral triangle and less for every other; (2) 0 for a triangle without area;
/// (3) independent of position, size and the order of the corners, within rounding. Cost: O(1).
double compute_q(const Vec3& a, const Vec3& b, const Vec3& c);

/// Least angle of the triangle a b c, degrees in [0, 60]; 0 for a triangle without area. Cost: O(1).
double compute_min_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// The figures of TriangleQuality over all faces, summed in the order of their ids; all zero for a mesh without faces.
/// Cost: O(n).
TriangleQuality compute_triangle_quality(const Mesh& mesh);

/// The numbers of edges at the vertices. A regular vertex has six, on the boundary four.
struct Valences {
  std::int32_t least = 0;
  std::int32_t largest = 0;
  double percent_regular = 0;  ///< percentage of regular vertices, in [0, 100]
};

/// Computes the valences of a mesh; all are zero for a mesh without vertices. Cost: O(n).
Valences compute_valences(const Mesh& mesh);

}  // namespace gvd
