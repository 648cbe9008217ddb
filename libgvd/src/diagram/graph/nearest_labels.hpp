#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "gvd/ids.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Nearest generator of every vertex of the working mesh.
struct NearestLabels {
  IdVector<VertexId, GeneratorId> label;  ///< invalid where no generator reaches
  IdVector<VertexId, double> distance;    ///< to that generator, with its symbolic offset; infinity where unreached
  /// Vertices without a neighbour of the same label that is nearer to the generator: their generator's front came
  /// through the inside of an edge.
  std::vector<VertexId> unsupported;
};

/// The label of a vertex is its nearest generator by (distance, generator id), that of a generator's vertex the
/// generator. Every other vertex than the unsupported ones has a neighbour of its label that is nearer to the
/// generator. Cost: O(n).
NearestLabels compute_nearest_labels(const WorkingMesh& working, const GeneratorTable& table);

/// The same from exact distances and labels. The unsupported vertices are looked for by several threads, at the
/// beginning of the step "bisectors".
NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const ParallelChunks& parallel);

/// Gives these vertices the label of a neighbour that keeps its own, so that an edge joins each to its new cell.
/// Cost: O(k log k) for k vertices.
void relabel_from_neighbours(const WorkingMesh& working, const std::vector<VertexId>& vertices, NearestLabels& labels);

/// Relabels every vertex that no chain of edges with falling distance joins to its generator: then every cell is
/// connected by the edges between its vertices. Returns how many. Cost: O(n).
std::int64_t relabel_unsupported(const WorkingMesh& working, NearestLabels& labels);

}  // namespace gvd
