#pragma once

#include <vector>

#include "gvd/diagram.hpp"

namespace gvd::test {

/// A diagram by straight distances through space, in place of geodesic ones: cells may fall apart, and are cut exactly
/// by planes. Fills generators, vertex and face labels, vertex distances and pieces; no bisectors or branch points.
Diagram make_restricted_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

}  // namespace gvd::test
