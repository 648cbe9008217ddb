#pragma once

#include <array>
#include <span>
#include <vector>

#include "cell_regions.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/log_map.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Squared distance over a triangle, from a point source in its plane: the quadratic that three corner distances and
/// the edge lengths determine.
struct SquaredDistance {
  std::array<double, 3> corner;  ///< squared distance at the corners
  std::array<double, 3> side;    ///< squared length from corner i to corner i + 1

  /// At barycentric coordinates; never below 0, which distances that no plane source has could give.
  double at(const std::array<double, 3>& b) const;
};

/// Adds up integrals over one cell whose generator's log map is known.
class CellIntegrals {
 public:
  explicit CellIntegrals(const Mesh& mesh) : mesh_(mesh), solver_(mesh) {}

  /// The moments of the cell with these parts about `generator`, which need not be the cell's own.
  /// A part that no path reaches within the cell's faces is reached over the whole mesh. Cost: O(k log k) for k parts.
  CellMoments compute(const SurfacePoint& generator, std::span<const CellPart> parts);

 private:
  void add(const CellPart& part, const std::array<Vec2, 3>& log, CellMoments& sum) const;

  const Mesh& mesh_;
  LogMapSolver solver_;
  std::vector<FaceId> faces_;  // scratch
};

}  // namespace gvd
