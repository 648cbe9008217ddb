#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// `count` different vertices, each with the same probability, in the order in which they were drawn; `count` from 0 to
/// the number of vertices. The beginning of a random permutation, so that a smaller count gives the first ones of
/// these.
/// Cost: O(n).
std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

/// The same as surface points. Throws Error{precondition} if the mesh has fewer vertices.
std::vector<SurfacePoint> sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

}  // namespace gvd
