#pragma once

#include "gvd/remesh.hpp"

namespace gvd {

/// Points that a map and its inverse give.
struct MapPoints {
  IdVector<VertexId, SurfacePoint> images;   ///< per vertex of the surface: its point of the remesh
  IdVector<VertexId, SurfacePoint> origins;  ///< per vertex of the remesh: its point of the surface
};

/// Points by a one-to-one map from the surface to the remesh: docs/developer/proofs.md.
///
/// Throws Error{no_valid_result} where a condition of the proof does not hold, with the first one that fails.
/// Deterministic, for every number of threads. Cost: O(n log n), and a sparse system for each cell.
MapPoints one_to_one_points(const Mesh& surface, const RemeshResult& result, int threads);

}  // namespace gvd
