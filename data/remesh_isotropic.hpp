#pragma once

#include <functional>

#include "gvd/vec.hpp"
#include "marching_tetrahedra.hpp"

namespace gvd::data {

/// Makes the edges of a closed mesh about `edge_length` long (mesh units) and its triangles near equilateral. Vertices
/// move only along the surface that `project` leads back to. The topology stays.
/// Source: Botsch and Kobbelt, A remeshing approach to multiresolution modeling, 2004, section 4.
Triangles remesh_isotropic(const Triangles& input, double edge_length, int rounds,
                           const std::function<Vec3(const Vec3&)>& project);

}  // namespace gvd::data
