#pragma once

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// The mesh with some of its edges collapsed, by the least quadric error first, until it has about `faces` faces.
/// Vertices of the result are vertices of the input. A collapse that turns a normal by more than 60 degrees is left
/// out.
///
/// Source: Garland and Heckbert, Surface simplification using quadric error metrics, 1997; OpenMesh's decimater.
/// Triangles of the result have worse shapes than those of an isotropic remeshing, as decimated scans do.
Mesh decimate(const Mesh& mesh, int faces);

}  // namespace gvd::paper
