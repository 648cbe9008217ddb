#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::bench {

/// A flat open square of n x n unit squares, each cut in two triangles. n >= 1.
Mesh make_flat_square(int n);

struct InteriorEnergy {
  int cells = 0;
  double energy = 0;  ///< sum of the energies x cells / (sum of the areas)^2: 0.16038 for a honeycomb
};

/// Of the cells whose generators are at least `margin` cell widths, sqrt(area / cells), within make_flat_square(n).
/// Cells at the boundary cannot be hexagons, and shape their neighbours.
InteriorEnergy interior_energy(const Mesh& square, int n, const Diagram& diagram, double margin);

}  // namespace gvd::bench
