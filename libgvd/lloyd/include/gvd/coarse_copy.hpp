#pragma once

#include <cstdint>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// A mesh with fewer faces near the same surface, and the way from each of the two to the other.
///
/// Properties: (1) the copy has the components, boundary loops and handles of the input; (2) its vertices are vertices
/// of the input, and those on the boundary are on the input's; (3) each vertex of the input leads to one of the copy in
/// the same component, near by; (4) the same for any number of threads.
struct CoarseCopy {
  Mesh mesh;
  IdVector<VertexId, VertexId> input_vertex;  ///< per vertex of the copy, ascending
  IdVector<VertexId, VertexId> copy_vertex;   ///< per vertex of the input
};

/// Bounds on the faces of a copy. What generators need goes before `most`.
struct CopySize {
  std::int64_t least = 5'000;
  std::int64_t most = 40'000;
  std::int64_t per_generator = 10;
};

/// The faces that a copy of a mesh of so many faces needs for so many generators; 0 where it would have more than half
/// of the mesh's. Meshes of 13,000 to 28,000 faces were relaxed as fast without a copy, and one of 69,451 was not.
std::int64_t default_copy_faces(std::int64_t mesh_faces, std::int64_t generators, const CopySize& size = {});

/// The copy of about so many faces, or of more where no edge can be collapsed without a change of topology or a fold.
///
/// Halfedges collapse, the one first that costs the least, by the error quadrics of the faces and of the boundary. A
/// small cost for long edges keeps flat parts even. `faces` >= 1; `threads` >= 0, 0 for one a core. Throws
/// Error{interrupted} if the progress callback cancels, and Error{invalid_option} for a number out of its range.
/// Source: Garland and Heckbert, Surface simplification using quadric error metrics, 1997; Dey et al., Topology
/// preserving edge contraction, 1999. Cost: O(n log n); 60 bytes a face.
CoarseCopy make_coarse_copy(const Mesh& mesh, std::int64_t faces, int threads = 0, const Progress& progress = {});

}  // namespace gvd
