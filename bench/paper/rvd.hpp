#pragma once

#include <vector>

#include "comparators.hpp"
#include "gvd/ids.hpp"
#include "gvd/vec.hpp"
#include "pieces.hpp"

namespace gvd::paper {

/// The neighbours of every point in the three-dimensional Delaunay triangulation: those whose bisector planes can bound
/// its Voronoi cell. Points may be coplanar, collinear, or two only; they must differ.
///
/// Source: CGAL's Delaunay_triangulation_3, which is under the GPL. In builds without it every point is a neighbour of
/// every other one: the cells are the same, and the time is not.
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points);

/// The faces of a mesh, cut where the three-dimensional Voronoi diagram of the generators intersects them. Cost: one
/// clip for each neighbour of each cell that intersects a face.
Pieces clip_to_voronoi_cells(const Mesh& mesh, const std::vector<Vec3>& positions,
                             const std::vector<std::vector<GeneratorId>>& neighbours);

/// Where the generators are, mesh units.
std::vector<Vec3> find_positions(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

/// The restricted Voronoi diagram: the surface cut by the cells of straight distances in space.
///
/// Source: D.-M. Yan, B. Levy, Y. Liu, F. Sun, W. Wang, Isotropic remeshing with fast and exact computation of
///   restricted Voronoi diagram, 2009: [29] in the paper, section 5.5.
/// Generators may lie anywhere. `field_ms`: the Delaunay triangulation. Islands are what [28] calls orphans.
Comparison compute_rvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

}  // namespace gvd::paper
