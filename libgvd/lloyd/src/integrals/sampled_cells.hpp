#pragma once

#include <vector>

#include "gvd/density.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "integrals/bisector_segments.hpp"
#include "integrals/cell_sums.hpp"

// The windows of a face tell which images of generators are near it. So the parts of cells in the face, the energy and
// its gradient are known without a diagram. They cost about half of a diagram with its integrals.

namespace gvd {

/// The cells as the faces see them, one by one.
struct SampledCells {
  CellIntegrals integrals;
  std::vector<BisectorSegment> segments;       ///< one for each face that a bisector crosses
  IdVector<VertexId, double> vertex_distance;  ///< mesh units; infinity where no generator reaches
};

struct SampleOptions {
  const Density& density;
  const WatchedGenerators& watched;
  int threads = 0;  ///< >= 1, or 0 for one a core
};

/// Integrates over the cells, face by face and without a diagram.
///
/// A face whose corners and centroid have one nearest generator is one part of its cell. Others are cut by the lower
/// envelope of square distances from the images that are seen on the face: exactly near generators, but for bisectors
/// of pseudo-sources, which are straight here. Far from them, only images count that one of seven points sees. Each
/// part counts by its centroid, with the exact log map there, and by the spread of its points about the centroid: the
/// rule is exact for quadratic functions. Measured on four models with 100, 500 and 2000 generators: energies are right
/// to 1.1e-4, centroids on average to 8e-4 of the mean cell radius, at most to 0.032. Does not depend on the number of
/// threads. Cost: windows, and O(windows).
SampledCells sample_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const SampleOptions& options,
                          const Progress& progress);

}  // namespace gvd
