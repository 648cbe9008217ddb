#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::paper {

/// The sum of the angles by which the bisectors turn at their inner points, radians: how much they zig-zag (figure 10
/// of the paper). Angles are measured with the two faces unfolded, so that a straight geodesic turns by 0; at a vertex
/// of the mesh they are those in space. Both senses count as positive. Throws Error{precondition} if consecutive points
/// share no face.
/// Cost: O(points).
double sum_turning_angles(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd::paper
