#pragma once

#include <array>
#include <utility>
#include <vector>

#include "window_integrals.hpp"

namespace gvd {

/// A straight part of the bisector of two cells within a face, with the figures that the Hessian of the energy needs.
struct BisectorSegment {
  GeneratorId left, right;  ///< the smaller id first
  double length = 0;        ///< mesh units
  /// The integral of the density along it, divided by the distance of the generators' images in the plane of the face.
  double weight = 0;
  /// The logarithms of its two Gauss points at the generators, mesh units.
  std::array<Vec2, 2> at_left{Vec2(0, 0), Vec2(0, 0)}, at_right{Vec2(0, 0), Vec2(0, 0)};
};

/// Sorts segments by their cells, and keeps the order of segments with the same cells. Cost: O(segments + cells).
void sort_by_cells(std::vector<BisectorSegment>& segments);

/// The pairs of cells with common segments, each pair once, ascending. The segments must be sorted. Cost: O(segments).
std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments);

/// The figures of the cells that a relaxation needs besides their integrals.
struct CellGeometry {
  std::vector<BisectorSegment> segments;  ///< of all bisectors, sorted by cells
  IdVector<VertexId, GeneratorId> label;  ///< the nearest generator; invalid if none reaches the vertex
  /// To the nearest generator, mesh units; infinity if none reaches the vertex.
  IdVector<VertexId, double> vertex_distance;
  IdVector<VertexId, Vec2> log;  ///< of the vertices at their nearest generators, mesh units
};

/// Finds the geometry of the cells, from windows with departures.
/// Cost: O(n), and O(windows) for faces at bisectors.
CellGeometry find_geometry(const WorkingMesh& working, const WindowField& windows,
                           const std::vector<SurfacePoint>& generators, const Density& density,
                           const ParallelChunks& parallel);

struct MeasuredCells {
  CellIntegrals integrals;
  CellGeometry geometry;
};

/// Integrates over the cells, face by face and without a diagram.
///
/// A face whose corners have the same nearest generator and smooth logarithms is measured as a whole, by these
/// logarithms. If only the logarithms are not smooth, but the centroid has the same generator, too, the face is
/// measured as a whole by the exact logarithm of its centroid. Other faces are cut by the lower envelope of squared
/// distances from the images that the face sees. Near generators the cuts are exact, except for bisectors of
/// pseudo-sources, which are taken as straight. Far from generators, only images count that one of seven points sees.
/// Each part is integrated at its centroid, with the exact logarithm there and the spread of its points about the
/// centroid. This rule is exact for quadratic functions.
///
/// On four models with 100, 500 and 2000 generators, the error of energies is at most 1.6e-4, and the mean error of
/// centroids at most 9e-4 of the mean cell radius. The result does not depend on `threads` (>= 1, or 0 for as many as
/// there are cores).
/// Cost: the propagation of windows, and O(windows).
MeasuredCells measure_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Integrand& integrand,
                            int threads, const Progress& progress);

}  // namespace gvd
