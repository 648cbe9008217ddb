#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// Where a vertex would have better triangles, and the direction across them.
struct VertexShape {
  Vec3 position;
  Vec3 normal;  ///< of its faces by their areas; zero where they have none
};

/// Where each vertex would have better triangles. Each of its faces has an edge opposite to it, over which an
/// equilateral triangle in the face's plane stands. The position is the weighted mean of the apexes of these triangles;
/// that of a vertex without faces is its own. A face weighs by the reciprocal of its quality 4 sqrt(3) area / (sum of
/// square edge lengths), so that bad triangles improve first. Moves of a vertex to there are Jacobi steps of a
/// smoothing.
/// Cost: O(n).
std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh);

}  // namespace gvd
