#pragma once

#include "geodesic/fast_marching.hpp"
#include "gvd/ids.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Nearest generator of every vertex of the working mesh, connected.
struct NearestLabels {
  IdVector<VertexId, GeneratorId> label;   ///< invalid where no generator reaches
  IdVector<VertexId, double> distance;     ///< to that generator, with its symbolic offset; infinity where unreached
  std::int64_t relabelled = 0;             ///< vertices that could not keep their nearest generator
};

/// The label of a vertex is its nearest generator by (distance, generator id), provided that a chain of edges with the
/// same label and falling distance joins it to that generator: so every cell is connected by construction. A vertex
/// without such a chain (its generator's front came through the inside of an edge) takes the next one that has it.
/// Cost: O(n).
NearestLabels compute_nearest_labels(const WorkingMesh& working, const GeneratorTable& table);

}  // namespace gvd
