#pragma once

#include <cstdint>

#include "gvd/mesh.hpp"

// The same surface with other triangles, for tables 1 to 5.

namespace gvd::paper {

/// A closed mesh of about `faces` near-equilateral triangles, with vertices on the surface of `mesh`. Source: Botsch
/// and Kobbelt, A remeshing approach to multiresolution modeling, 2004. Sharp edges are rounded off. The number of
/// faces is met within some 20 %. Throws Error{precondition} if `mesh` has a boundary.
Mesh resample(const Mesh& mesh, int faces);

/// The same faces with vertices moved towards random neighbours, until `percent_below_30` of all triangles have an
/// angle below 30 degrees or kMostJitterRounds are over. A move that turns a normal by more than 60 degrees, or that
/// makes a triangle of Q below 0.1, is left out. Equal seeds give equal meshes.
Mesh jitter(const Mesh& mesh, double percent_below_30, std::uint64_t seed);

inline constexpr int kMostJitterRounds = 20;

/// The unit sphere, as an icosahedron with every face cut in four `subdivisions` times: 20 * 4^subdivisions faces.
Mesh make_icosphere(int subdivisions);

}  // namespace gvd::paper
