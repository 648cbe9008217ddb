#pragma once

#include <array>
#include <utility>
#include <vector>

#include "window_integrals.hpp"

namespace gvd {

/// A straight piece of the bisector of two cells, in one face, as the Hessian of the energy needs it.
struct BisectorSegment {
  GeneratorId left, right;  ///< the lesser one first
  double length = 0;        ///< mesh units
  /// Integral of the density along it, divided by the distance of the generators' images in the plane of the face.
  double weight = 0;
  /// Logarithms of its two Gauss points at the generators, mesh units.
  std::array<Vec2, 2> at_left{Vec2(0, 0), Vec2(0, 0)}, at_right{Vec2(0, 0), Vec2(0, 0)};
};

/// Sorts segments by their cells, and keeps the order of those with the same cells. Cost: O(segments + cells).
void sort_by_cells(std::vector<BisectorSegment>& segments);

/// The pairs of cells that share sorted segments, each pair once, ascending. Cost: O(segments).
std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments);

/// Where the cells are: what the relaxation needs to know of them beside their integrals.
struct CellGeometry {
  std::vector<BisectorSegment> segments;       ///< of all bisectors, sorted by cells
  IdVector<VertexId, GeneratorId> label;       ///< the nearest generator; invalid where none reaches
  IdVector<VertexId, double> vertex_distance;  ///< to the nearest generator, mesh units; infinity where none reaches
  IdVector<VertexId, Vec2> log;                ///< of the vertices at their nearest generators, mesh units
};

/// The geometry of the cells, from windows with departures.
/// Cost: O(n), and O(windows) of faces at bisectors.
CellGeometry find_geometry(const WorkingMesh& working, const WindowField& windows,
                           const std::vector<SurfacePoint>& generators, const Density& density,
                           const ParallelChunks& parallel);

struct MeasuredCells {
  CellIntegrals integrals;
  CellGeometry geometry;
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
/// average by at most 9e-4 of the mean cell radius. Does not depend on `threads` (>= 1, or 0 for one a core).
/// Cost: that of the windows, and O(windows).
MeasuredCells measure_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Integrand& integrand,
                            int threads, const Progress& progress);

}  // namespace gvd
