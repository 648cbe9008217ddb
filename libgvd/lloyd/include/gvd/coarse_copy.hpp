#pragma once

#include <cstdint>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

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

/// The point of `input` near a point of the copy: the closest one among the faces within the reach of the copy's face,
/// connected with its vertices. So it stays in its component and on its sheet. Cost: O(k log k) for k such faces.
SurfacePoint to_input(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// The point of the copy near a point of `input`, by the same rule. Cost: as `to_input`.
SurfacePoint to_copy(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// The same for many points. The progress goes from the beginning of the part to its end. Throws Error{interrupted} if
/// the callback cancels.
std::vector<SurfacePoint> to_input(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                   const Progress& progress, const StepPart& part);
std::vector<SurfacePoint> to_copy(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                  const Progress& progress, const StepPart& part);

/// Whether no two of the points coincide (find_coincident).
bool are_apart(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// `sample_generators` on the copy, each point moved to the input; on the input itself where two would coincide.
/// Throws Error{interrupted} if the progress callback of the options cancels.
std::vector<SurfacePoint> sample_on_copy(const Mesh& input, const CoarseCopy& copy, const SamplingOptions& options);

/// The density on the copy: at a vertex the mean over the part of `input` that collapsed to it. Cost: O(n).
Density to_copy(const Mesh& input, const CoarseCopy& copy, const Density& density);

}  // namespace gvd
