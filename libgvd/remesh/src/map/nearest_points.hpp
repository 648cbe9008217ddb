#pragma once

#include "gvd/remesh.hpp"

namespace gvd {

/// The nearest point of the remesh for each vertex of the surface, on the triangles at its cell's vertex and at the
/// neighbours of that vertex. `map_to_remesh` says more. Several vertices may have the same point. Throws
/// Error{precondition} if a vertex is in no cell. Cost: O(n) for vertices of bounded valence.
IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads,
                                                const Progress& progress = {});

}  // namespace gvd
