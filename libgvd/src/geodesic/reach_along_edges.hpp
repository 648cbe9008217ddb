#pragma once

#include "geodesic/window_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Gives every vertex that no window reached, in a component that a generator reaches, the distance along edges from its
/// nearest labelled neighbours. Faces without area let no window through, so that what lies behind them stays out of reach.
/// Cost: O(n + k log k) for k such vertices; none on a mesh whose faces have an area.
void reach_along_edges(const Mesh& mesh, WindowField& field);

}  // namespace gvd
