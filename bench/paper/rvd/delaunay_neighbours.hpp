#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd::paper {

/// The neighbours of every point in the three-dimensional Delaunay triangulation: those whose bisector planes can bound
/// its Voronoi cell. Points may be coplanar, collinear, or two only; they must differ.
///
/// Source: CGAL's Delaunay_triangulation_3, which is under the GPL. In builds without it every point is a neighbour of
/// every other one: the cells are the same, and the time is not.
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points);

}  // namespace gvd::paper
