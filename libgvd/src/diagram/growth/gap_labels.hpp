#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/gap_edges.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The labels of a gap's vertices that follow from its crossings, where they differ from `labels`; ascending by vertex.
///
/// Vertices on the rim and generators keep their labels; from there labels spread along the gap's edges, and change
/// where an edge is crossed. Nothing if a vertex gets no label, or two edges contradict each other.
/// Cost: O(k log k) for k edges.
std::optional<std::vector<std::pair<VertexId, GeneratorId>>> find_moved_labels(const WorkingMesh& working,
                                                                               const NearestLabels& labels,
                                                                               const GapEdges& gap_edges);

}  // namespace gvd
