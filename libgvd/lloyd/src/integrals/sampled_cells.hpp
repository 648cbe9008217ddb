#pragma once

#include <vector>

#include "gvd/density.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "integrals/bisector_segments.hpp"
#include "integrals/cell_sums.hpp"

// Every point of the surface has an exact distance to its nearest generator, whether or not a diagram is known. So the
// energy and its gradient are sums over points of the faces. They cost about half of a diagram with its integrals.

namespace gvd {

/// The cells as points of the faces see them.
struct SampledCells {
  CellIntegrals integrals;
  std::vector<BisectorSegment> segments;       ///< from middle to middle of the edges with two labels
  IdVector<VertexId, double> vertex_distance;  ///< mesh units; infinity where no generator reaches
};

struct SampleOptions {
  const Density& density;
  const WatchedGenerators& watched;
  int threads = 0;  ///< >= 1, or 0 for one a core
};

/// Integrates over the cells by points of the faces: each counts for its nearest generator, with the exact distance and
/// log map.
///
/// Faces whose corners have one nearest generator have one point. Others have nine, because a bisector may cross
/// them. Each point stands for an equal triangle, and the spread of the triangle about its centroid is added: the rule
/// is exact for quadratic functions. Bisectors make errors: with 69,451 faces, the centroids are off by 0.1 per cent of
/// the mean cell radius with 100 cells, and by 0.5 per cent with 1,000. The sum is continuous in the generators, and
/// has the mean log maps for its gradient. Does not depend on the number of threads.
/// Cost: windows, and O(windows).
SampledCells sample_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const SampleOptions& options,
                          const Progress& progress);

}  // namespace gvd
