#pragma once

#include <array>
#include <span>
#include <vector>

#include "cell_faces.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/log_map.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Squared distance over a triangle, from a point source in its plane. Three corner distances and the edge lengths
/// determine this quadratic function.
struct SquaredDistance {
  std::array<double, 3> corner;  ///< squared distance at the corners
  std::array<double, 3> side;    ///< squared length of the side from corner i to corner i + 1

  /// The value at barycentric coordinates b. Clamped to 0: distances that no source in the plane has can give less.
  double at(const std::array<double, 3>& b) const;
};

/// Computes the integrals over single cells; keeps its work space between them.
class CellIntegrals {
 public:
  /// Both have to outlive this.
  explicit CellIntegrals(const Mesh& mesh, const Density& density = kUniform)
      : mesh_(mesh), density_(density), solver_(mesh) {}

  const Mesh& mesh() const { return mesh_; }
  const Density& density() const { return density_; }

  /// The moments of the cell with these faces about `generator`, which need not be the cell's own. The log map covers
  /// the cell's faces, or the whole mesh if no path within the cell's faces leads to some of them.
  /// Cost: O(k log k) for k faces.
  CellMoments compute(const SurfacePoint& generator, std::span<const CellFace> cell);

 private:
  void add(const CellFace& face, const std::array<Vec2, 3>& log, CellMoments& sum) const;

  static const Density kUniform;

  const Mesh& mesh_;
  const Density& density_;
  LogMapSolver solver_;
  std::vector<FaceId> faces_;  // scratch
};

}  // namespace gvd
