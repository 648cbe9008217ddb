#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "gvd/charts.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A region that shares bisectors with another one.
struct RegionNeighbour {
  GeneratorId region;
  double border_length = 0;  ///< of all bisectors between the two, mesh units
};

/// Figures of one region. They are those of the diagram's cell, not of labelled faces: the same for every way to label.
struct RegionStatistics {
  double area = 0;       ///< square mesh units
  double share = 0;      ///< of the area of the mesh, in [0, 1]
  double perimeter = 0;  ///< bisectors, and what the cell has of the mesh's boundary; mesh units
  /// Largest known distance from the generator within the cell: at vertices, at branch points, and at corners of the
  /// cell in faces that hold the generator. The cell reaches farther by less than the longest edge. Mesh units.
  double radius = 0;
  double compactness = 0;                   ///< 4 pi area / perimeter^2: 1 for a flat disc; infinite without perimeter
  std::int32_t euler_characteristic = 0;    ///< 1 for a disc, 0 for an annulus, 2 for a sphere
  std::vector<RegionNeighbour> neighbours;  ///< ascending
};

/// The figures of every cell.
///
/// Area and Euler characteristic are the diagram's own. Lengths are those of the polylines, which are as close to the
/// curves as the diagram's chord tolerance. A bisector between a cell and itself counts twice in its perimeter, once
/// for each side. Throws Error{precondition} if the diagram was not made of this mesh. Cost: O(n log n).
IdVector<GeneratorId, RegionStatistics> compute_region_statistics(const Mesh& mesh, const Diagram& diagram);

/// Writes CSV after RFC 4180: a header, then a line for each region, ended by CR LF. Numbers have the fewest digits
/// that read back as the same double, in any locale. What is not finite is an empty field. `charts`: of these regions,
/// for six more columns: the share of the area that is flipped, the stretch, and the box of the texture coordinates.
void write_statistics_csv(std::ostream& out, const IdVector<GeneratorId, RegionStatistics>& regions,
                          const Charts* charts = nullptr);

/// Writes the adjacency of the regions as GraphML: an undirected graph with a node for each region and an edge for each
/// two that share bisectors. A node has the label as its id, and `label`, `area`, `x`, `y` and `z`, the position of the
/// generator; an edge has `length`, that of the bisectors. Numbers as above.
/// Throws Error{precondition} where there is not a region for each of the generators.
void write_adjacency_graphml(std::ostream& out, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const IdVector<GeneratorId, RegionStatistics>& regions);

}  // namespace gvd
