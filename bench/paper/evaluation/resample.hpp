#pragma once

#include <functional>

#include "gvd/mesh.hpp"

// The same surface with other triangles, for tables 1 to 5.

namespace gvd::paper {

/// Makes a mesh of one surface with edges of about this length, mesh units.
using Remesher = std::function<Mesh(double edge_length)>;

/// A mesh of `faces` faces of a surface with this area: calls the remesher with one length after the other, until the
/// number is met within kFacesTolerance, or kMostTries are over; then the nearest one.
Mesh search_edge_length(const Remesher& remesh, double area, int faces);

inline constexpr double kFacesTolerance = 0.03;  ///< a fraction of the number of faces
inline constexpr int kMostTries = 10;

/// A closed mesh of near-equilateral triangles, with vertices on the surface of `mesh`. Source: Botsch and Kobbelt, A
/// remeshing approach to multiresolution modeling, 2004. Sharp edges are rounded off. The number of faces is searched
/// by `search_edge_length`. Throws Error{precondition} if `mesh` has a boundary.
Mesh resample(const Mesh& mesh, int faces);

}  // namespace gvd::paper
