#pragma once

#include <array>
#include <functional>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd::data {

struct Triangles {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;  ///< counter-clockwise seen from outside
};

/// A box of cubes with edge `spacing`, `cells` of them along each axis, from `corner` on.
struct Grid {
  Vec3 corner;
  double spacing;
  std::array<int, 3> cells;
};

/// Polygonises the surface value = 0 (negative inside) with six tetrahedra a cube: closed and manifold by construction
/// where the surface does not leave the box, since neighbouring tetrahedra share whole faces.
/// Source: Doi and Koide, An efficient method of triangulating equi-valued surfaces by using tetrahedral cells, 1991.
Triangles polygonise(const std::function<double(const Vec3&)>& value, const Grid& grid);

}  // namespace gvd::data
