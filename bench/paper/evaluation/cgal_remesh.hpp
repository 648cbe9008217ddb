#pragma once

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// Whether this build has CGAL's GPL-licensed remeshing.
bool has_cgal_remeshing();

/// A closed mesh of `faces` near-equilateral triangles, by `search_edge_length` and CGAL's
/// Polygon_mesh_processing::isotropic_remeshing, which is under the GPL. Vertices lie on the surface of `mesh`. Throws
/// Error{precondition} if `mesh` has a boundary, or in a build without CGAL.
Mesh remesh_with_cgal(const Mesh& mesh, int faces);

}  // namespace gvd::paper
