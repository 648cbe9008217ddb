#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A weighted sum of square distances from planes and lines. As a function of an offset d from a fixed point it is
/// d' matrix d - 2 vector' d, and a constant.
struct Quadric {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 vector = Vec3::Zero();
  double area = 0;  ///< of the faces, square mesh units

  /// A plane through `through`, an offset, with a unit normal.
  void add_plane(const Vec3& normal, const Vec3& through, double weight);
  /// A line through `through` along a unit vector.
  void add_line(const Vec3& along, const Vec3& through, double weight);

  /// The least offset among those with the least sum. Directions in which the sum hardly changes are left out: those of
  /// eigenvalues below `truncation` times the largest one. Zero for an empty sum.
  Vec3 minimize(double truncation) const;
};

/// The quadrics of all cells, with offsets from their generators. Planes of faces weigh by their areas in the cell.
/// Lines of boundary edges weigh by their lengths in the cell times the square root of the cell's area. Cost: O(n).
IdVector<GeneratorId, Quadric> compute_cell_quadrics(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
