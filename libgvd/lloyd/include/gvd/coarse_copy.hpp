#pragma once

#include <cstdint>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// A mesh with fewer faces near the same surface, with maps between the vertices of the two meshes.
///
/// Properties: (1) the copy has the components, boundary loops and handles of the input; (2) its vertices are vertices
/// of the input, and its boundary vertices are boundary vertices of the input; (3) each vertex of the input maps to a
/// nearby vertex of the copy in the same component; (4) the copy is the same for any number of threads.
struct CoarseCopy {
  Mesh mesh;
  IdVector<VertexId, VertexId> input_vertex;  ///< for each vertex of the copy, ascending
  IdVector<VertexId, VertexId> copy_vertex;   ///< for each vertex of the input
};

/// Bounds on the number of a copy's faces. `per_generator` takes precedence over `most`.
struct CopySize {
  std::int64_t least = 5'000;
  std::int64_t most = 40'000;
  std::int64_t per_generator = 10;
};

/// The number of faces that a copy of a mesh with `mesh_faces` faces needs for this many generators; 0 if that is more
/// than half of the mesh's faces.
std::int64_t default_copy_faces(std::int64_t mesh_faces, std::int64_t generators, const CopySize& size = {});

/// Makes a copy of about `faces` faces. It has more if no further edge can be collapsed without changing the topology
/// or folding the surface.
///
/// Collapses halfedges in the order of their cost, which comes from the error quadrics of the faces and of the
/// boundary. A small cost for long edges keeps flat parts even. `faces` >= 1; `threads` >= 0, 0 for as many as there
/// are cores. Throws Error{interrupted} if the progress callback cancels, and Error{invalid_option} for a number out of
/// range.
/// Source: Garland and Heckbert, Surface simplification using quadric error metrics, 1997; Dey et al., Topology
/// preserving edge contraction, 1999. Cost: O(n log n); 60 bytes a face.
CoarseCopy make_coarse_copy(const Mesh& mesh, std::int64_t faces, int threads = 0, const Progress& progress = {});

}  // namespace gvd
