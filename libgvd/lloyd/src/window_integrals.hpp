#pragma once

#include "base/parallel_chunks.hpp"
#include "cell_sums.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The integrand, and how finely it is integrated.
struct Quadrature {
  const Density& density;
  const WatchedGenerators& watched;
  int divisions = 1;  ///< >= 1
};

/// The moments of all cells of an exact diagram, from the windows of which it was traced.
///
/// Quadrature: whole faces, and the triangles into which each piece is cut, are divided into `divisions`^2 equal
/// triangles with three inner points each. This rule is exact for quadratic functions, and so where all paths to a
/// triangle come straight from one image. Distances and log map are exact at the points. Triangles that a ridge
/// crosses, behind a vertex with curvature, have an error. On the bunny with 69,451 faces and 100 generators it is 5e-6
/// of the whole energy with one division, and 3e-8 with three. Does not depend on the number of threads.
/// Cost: O(windows).
CellIntegrals integrate_over_windows(const WorkingMesh& working, const WindowField& field, const Diagram& diagram,
                                     const Quadrature& quadrature, const ParallelChunks& parallel);

/// The same for any diagram: the windows are propagated first. `threads` >= 1, or 0 for one a core.
/// Cost: that of the windows, and O(windows).
CellIntegrals integrate_cells(const Mesh& mesh, const Diagram& diagram, const Quadrature& quadrature, int threads);

}  // namespace gvd
