#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A subdivision of a sphere like a diagram, made without any algorithm of the library. Each vertex has the label of
/// the nearest of `m` vertices along great circles. Faces with two labels are cut where the distances are equal, faces
/// with three at their centre. Its Euler count holds where each cell is connected.
Diagram make_sphere_sample(const Mesh& sphere, int m);

/// The scene of a remesh of a sphere with vertices at its generators, whose distances are made up: 0 but for the middle
/// of each face, where it is kSampleBump.
ViewScene make_remesh_sample(const Mesh& sphere, const Mesh& other);

inline constexpr double kSampleBump = 0.2;

}  // namespace gvd::test
