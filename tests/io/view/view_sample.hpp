#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A diagram-like subdivision of a sphere, made without any algorithm of the library: vertices take the nearest of `m`
/// vertices along great circles, two-coloured faces are cut where the distances balance, three-coloured ones at their
/// centre. It is closed: its Euler count holds wherever each cell is connected.
Diagram make_sphere_sample(const Mesh& sphere, int m);

}  // namespace gvd::test
