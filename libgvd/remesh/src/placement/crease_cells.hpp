#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// An edge is sharp where the normals of its two faces differ by more than this, degrees.
inline constexpr double kSharpAngle = 40;

/// Whether each cell has a share of a face at a sharp edge or at the boundary. Cost: O(n).
IdVector<GeneratorId, char> find_crease_cells(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
