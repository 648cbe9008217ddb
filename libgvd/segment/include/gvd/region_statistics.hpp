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

/// A region that has bisectors in common with another region.
struct RegionNeighbour {
  GeneratorId region;
  double border_length = 0;  ///< of all bisectors between the two, mesh units
};

/// Figures of a region. They describe the diagram's cell and not the labelled faces, so they do not depend on how faces
/// are labelled.
struct RegionStatistics {
  double area = 0;       ///< square mesh units
  double share = 0;      ///< of the area of the mesh, in [0, 1]
  double perimeter = 0;  ///< length of its bisectors and of its part of the mesh's boundary; mesh units
  /// Largest known distance from the generator within the cell: at vertices, at branch points, and at corners of the
  /// cell in faces that contain the generator. No point of the cell is farther by more than the longest edge. Mesh
  /// units.
  double radius = 0;
  double compactness = 0;                   ///< 4 pi area / perimeter^2: 1 for a flat disc; infinite without perimeter
  std::int32_t euler_characteristic = 0;    ///< 1 for a disc, 0 for an annulus, 2 for a sphere
  std::vector<RegionNeighbour> neighbours;  ///< ascending
};

/// Computes the figures of every cell.
///
/// Area and Euler characteristic are the diagram's own. Lengths are measured on the polylines, which are within the
/// diagram's chord tolerance of the curves. A bisector between a cell and itself counts twice in the perimeter, once
/// for each side. Throws Error{precondition} if the diagram was not made of this mesh. Cost: O(n log n).
IdVector<GeneratorId, RegionStatistics> compute_region_statistics(const Mesh& mesh, const Diagram& diagram);

/// Writes CSV after RFC 4180: a header, then a line for each region, ended by CR LF. Numbers have the fewest digits
/// that read back as the same double, in any locale; numbers that are not finite are empty fields. With `charts`, the
/// charts of these regions, adds six columns: the share of the area that is flipped, the stretch, and the box of the
/// texture coordinates.
void write_statistics_csv(std::ostream& out, const IdVector<GeneratorId, RegionStatistics>& regions,
                          const Charts* charts = nullptr);

/// Writes the adjacency of the regions as GraphML: an undirected graph with a node for each region and an edge for each
/// pair of regions with common bisectors. A node has its label as id, and the keys `label`, `area`, and `x`, `y` and
/// `z` for the position of the generator. An edge has the key `length`, the length of the bisectors. Numbers are
/// written as above.
/// Throws Error{precondition} if there is not one region for each generator.
void write_adjacency_graphml(std::ostream& out, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const IdVector<GeneratorId, RegionStatistics>& regions);

}  // namespace gvd
