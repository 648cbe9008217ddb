#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A weighted sum of square distances from planes and lines. As a function of an offset d from a fixed point it is
/// d' matrix d - 2 vector' d, and a constant.
struct Quadric {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 vector = Vec3::Zero();
  double area = 0;  ///< of the faces, square mesh units

  /// Adds a plane through `through`, an offset, with a unit normal.
  void add_plane(const Vec3& normal, const Vec3& through, double weight) {
    matrix += weight * normal * normal.transpose();
    vector += weight * normal.dot(through) * normal;
  }
  /// Adds a line through `through` along a unit vector.
  void add_line(const Vec3& along, const Vec3& through, double weight) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
    matrix += weight * across;
    vector += weight * across * through;
  }
  /// The least offset among those with the least sum. Directions in which the sum hardly changes, with eigenvalues
  /// below `truncation` times the largest one, are left out. Zero for an empty sum.
  Vec3 minimize(double truncation) const;
};

/// The quadrics of all cells, with offsets from their generators. The plane of a face has the weight of its area in the
/// cell. The line of a boundary edge has the weight of its length in the cell times the square root of the cell's area.
/// Cost: O(n).
IdVector<GeneratorId, Quadric> compute_cell_quadrics(const Mesh& mesh, const Diagram& diagram);

/// An edge is sharp where the normals of its two faces differ by more than this, degrees.
inline constexpr double kSharpAngle = 40;

/// A cell has a crease if its sharp edges carry at least this fraction of its bending, which is the sum of lengths
/// times angles between normals over the parts of edges in the cell. On creases of CAD models the fraction is nearly 1.
/// In noise and folds, the edges beside the sharp ones bend as well.
inline constexpr double kLeastBendingShare = 0.7;

/// A crease runs through many cells. A smaller group of neighbouring cells with sharp edges is a coarse, curved
/// surface: with 2000 generators, such groups have at most 4 cells on the elephant and 2 on spot, and the creases of
/// the fandisk have 391. If there are few generators, an eighth of them is enough.
inline constexpr std::int64_t kLeastCreaseCells = 12;

/// The demands of the sharp edges and of the boundary in a cell on the cell's vertex.
struct CreaseCell {
  bool is_creased = false;        ///< its triangles should meet a crease, or the boundary while the generator is off it
  Vec3 direction = Vec3::Zero();  ///< unit, along the crease; zero where there is none, or where several meet
  bool is_met = false;            ///< the generator is on a crease: its vertex leaves it for no angle
};

/// The creases of all cells. `remesh` has its vertices at the generators. Cost: O(n log n).
IdVector<GeneratorId, CreaseCell> find_crease_cells(const Mesh& surface, const Diagram& diagram, const Mesh& remesh);

}  // namespace gvd
