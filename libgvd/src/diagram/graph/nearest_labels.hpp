#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "gvd/ids.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The nearest generator of every vertex of the working mesh.
struct NearestLabels {
  IdVector<VertexId, GeneratorId> label;  ///< invalid if no generator reaches the vertex
  IdVector<VertexId, double> distance;    ///< to that generator, with its symbolic offset; infinity if none reaches it
  /// Vertices, other than generators, without a neighbour of the same label that is nearer to the generator. The path
  /// from the generator to such a vertex enters its last face through the inside of an edge.
  std::vector<VertexId> unsupported;
};

/// The paper's classes of faces, by the nearest generators of their corners (section 3, figure 2).
enum class FaceClass {
  unreached,  ///< a face with a corner that no generator reaches
  trivial,    ///< one generator
  ordinary,   ///< two
  branching,  ///< three
};

/// The class of a face, by the labels of its vertices. Cost: O(1).
FaceClass classify(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label, FaceId f);

/// Computes the labels from tables. The label of a vertex is its nearest generator by (distance, generator id); the
/// label of a generator's vertex is that generator. Cost: O(n).
NearestLabels compute_nearest_labels(const WorkingMesh& working, const GeneratorTable& table);

/// The same from exact distances and labels. Several threads find the unsupported vertices, at the beginning of the
/// step "bisectors".
NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const ParallelChunks& parallel);

/// The same if it is known which vertices other than `changed`, which ascend, are unsupported. `known` are the vertices
/// that were unsupported before, some of which may have changed. Cost: O(n) for the copies, and O(changed vertices).
NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const std::vector<VertexId>& known,
                          const std::vector<VertexId>& changed);

/// Gives these vertices the labels of neighbours that are not relabelled, so that a chain of edges connects each vertex
/// to its new cell. Distances become distances along the edges. Neighbours that lose their support are appended to
/// `unsupported`.
/// Cost: O(k log k) for k vertices.
void relabel_from_neighbours(const WorkingMesh& working, const std::vector<VertexId>& vertices, NearestLabels& labels);

/// Relabels every vertex that no chain of edges with decreasing distance connects to its generator. Afterwards every
/// cell is connected by the edges between its vertices. Returns the number of relabelled vertices. Cost: O(n).
std::int64_t relabel_unsupported(const WorkingMesh& working, NearestLabels& labels);

}  // namespace gvd
