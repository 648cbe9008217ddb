#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// The lengths from a path's first vertex to each of its vertices, mesh units. Cost: O(k).
std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path);

/// Scales ascending numbers that begin with 0 so that the last one is `last`, bit by bit. Makes their distances
/// more even.
/// `even_share`: share of even spacing in their distances, in [0, 1]. It keeps numbers apart that nearly coincide.
/// Needs two numbers at least, of which the last one is above 0. Cost: O(k).
void scale_and_even(std::vector<double>& values, double last, double even_share);

}  // namespace gvd
