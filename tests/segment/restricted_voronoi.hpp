#pragma once

#include <vector>

#include "gvd/diagram.hpp"

namespace gvd::test {

/// A diagram by Euclidean distances instead of geodesic ones. Its cells may be disconnected, and their borders are cut
/// exactly, by planes. Fills generators, vertex and face labels, vertex distances and pieces; no bisectors or branch
/// points.
Diagram make_restricted_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

}  // namespace gvd::test
