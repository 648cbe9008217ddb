#pragma once

#include <vector>

#include "gvd/density.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "integrals/bisector_segments.hpp"
#include "integrals/cell_sums.hpp"

// Cells without a diagram. The windows of a face tell which images of generators are near it, and so the parts of cells
// in the face. Energies and gradients cost about half of a diagram with its integrals.

namespace gvd {

/// What the relaxation needs to know of the cells.
struct MeasuredCells {
  CellIntegrals integrals;
  std::vector<BisectorSegment> segments;       ///< straight pieces of bisectors, one face each
  IdVector<VertexId, double> vertex_distance;  ///< mesh units; infinity where no generator reaches
};

struct MeasureOptions {
  const Density& density;
  const WatchedGenerators& watched;
  int threads = 0;  ///< >= 1, or 0 for one a core
};

/// Integrates over the cells, face by face and without a diagram.
///
/// A face whose corners have one nearest generator and smooth logarithms there counts as a whole, by these logarithms.
/// It also counts as a whole if its centroid has the same generator, by the exact logarithm there. Other faces are cut
/// by the lower envelope of square distances from the images that are seen on the face. Near generators the cuts are
/// exact, but for bisectors of pseudo-sources, which are straight here. Far from them, only images count that one of
/// seven points sees. Each part counts by its centroid, with the exact logarithm there, and by the spread of its points
/// about the centroid. This rule is exact for quadratic functions.
///
/// Measured on four models with 100, 500 and 2000 generators, energies are off by at most 1.6e-4. Centroids are off on
/// average by at most 9e-4 of the mean cell radius. Does not depend on the number of threads.
/// Cost: that of the windows, and O(windows).
MeasuredCells measure_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                            const MeasureOptions& options, const Progress& progress);

}  // namespace gvd
